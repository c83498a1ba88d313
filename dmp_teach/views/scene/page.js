// The view as a page of its own: its traits stand compressed in the page, and no kernel answers.

import { gunzip } from "./meshcat.js";
import { render } from "./scene.js";

/** Return the bytes that stand in the page under a name. */
function part(/** @type {string} */ name) {
  const letters = atob(document.getElementById(name).textContent);
  return Uint8Array.from(letters, (letter) => letter.charCodeAt(0));
}

/** @type {Record<string, any>} */
const state = JSON.parse(new TextDecoder().decode(await gunzip(part("state"))));
for (const { id } of document.querySelectorAll("script[id]:not(#state)")) state[id] = part(id);

/** @type {Record<string, (() => void)[]>} */
const listeners = {};

/** @type {import("../dom.js").Model} */
const model = {
  get: (name) => state[name],
  set(name, value) {
    if (state[name] === value) return;
    state[name] = value;
    for (const listener of listeners[`change:${name}`] ?? []) listener();
  },
  on(event, listener) {
    listeners[event] ??= [];
    listeners[event].push(listener);
  },
  save_changes() {},
};

const dark = window.matchMedia("(prefers-color-scheme: dark)");
const dress = () => {
  document.body.dataset.jpThemeLight = String(!dark.matches);
};
dark.addEventListener("change", dress);
dress();
render({ model, el: document.getElementById("view") });
