// A widget as a page of its own: its traits stand compressed in the page, and no kernel answers.

import { change, make } from "./dom.js";
import { gunzip } from "./gunzip.js";
import { t } from "./texts.js";
import { followTheme } from "./theme.js";
import { Traits } from "./traits.js";

/** @typedef {import("./dom.js").Model} Model */
/**
 * @typedef {{
 *   send?(model: Model, message: Record<string, any>): void, saved?(model: Model): void,
 * }} Answers what the page does in the place of Python when it is told, or traits were set
 */

/** Show a widget with the traits of the page. */
export async function showPage(
  /** @type {(widget: import("./dom.js").Widget) => void} */ render,
  /** @type {Answers} */ answers = {},
) {
  const packed = bytesOf(document.getElementById("state").textContent);
  const text = new TextDecoder().decode(await gunzip(packed));
  const state = JSON.parse(text, (_, value) =>
    value?.base64 === undefined ? value : bytesOf(value.base64),
  );
  const el = document.getElementById("view");
  followTheme(el);
  render({ model: modelOf(state, answers), el });
  rest(el);
}

function bytesOf(/** @type {string} */ base64) {
  return new DataView(Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0)).buffer);
}

/**
 * @param {Record<string, any>} state
 * @param {Answers} answers
 */
function modelOf(state, { send, saved }) {
  const traits = new Traits();
  traits.take(state);
  const answer = () => model.set("answered", model.get("answered") + 1);
  const model = traits.model({
    save_changes() {
      saved?.(model);
      answer();
    },
    send(message) {
      send?.(model, message);
      answer();
    },
  });
  return model;
}

/** Disable what only Python can answer, and say so once. */
function rest(/** @type {HTMLElement} */ el) {
  const asking = [...el.querySelectorAll("[data-dt-asks]")];
  const inner = "input, select, button";
  const all = asking.flatMap((node) => [node, ...node.querySelectorAll(inner)]);
  for (const node of all)
    change(node, { disabled: true, title: t("This needs a running notebook.") });
  if (!all.length) return;
  el.prepend(make("p", { class: "dt-rests" }, t("What is grey needs a running notebook.")));
}
