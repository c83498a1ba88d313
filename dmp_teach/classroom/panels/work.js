// What the robot does while nobody sees it: named steps with a bar, or what it cannot do.

import { change, make } from "../../views/dom.js";
import { t } from "../../views/texts.js";
import { button, ICONS, icon } from "./controls.js";

/** @typedef {import("../../views/dom.js").Model} Model */
/** @typedef {import("./robot.js").Parts} Parts */
/** @typedef {{ state: string, steps: string[], at: number, fraction: number }} Work */

/**
 * Named steps with a bar while the robot plans; or what cannot be done, by how much, and the cure.
 */
export function drawWork(/** @type {Model} */ model, /** @type {Parts} */ parts) {
  const [work, host] = [model.get("work"), parts.work];
  host.hidden = work.state === "idle";
  // No robot is seen at a page that it does not reach; its place is kept.
  parts.robotHost.classList.toggle("dt-away", Boolean(work.cure));
  host.className = `dt-work ${work.state === "cannot" ? "dt-cannot" : ""}`;
  change(parts.write, { "aria-disabled": work.state === "working" ? "true" : null });
  if (work.state === "working") showSteps(model, parts, work);
  if (work.state === "cannot") showCure(model, host, work);
}

/**
 * @param {Model} model
 * @param {Parts} parts
 * @param {Work} work
 */
function showSteps(model, parts, work) {
  const steps = parts.work.querySelector(".dt-steps");
  // The list is made anew at every report; the button stays, or a press between two reports would
  // be lost.
  if (steps) {
    steps.replaceWith(stepList(work));
    return;
  }
  const stop = () => {
    model.send({ kind: "stop" });
    parts.stopped = true;
  };
  const quiet = make("span", { class: "dt-quiet" }, "");
  const footer = make("footer", {}, quiet, button(t("Stop"), { onClick: stop }));
  parts.work.replaceChildren(stepList(work), footer);
}

/**
 * @param {Model} model
 * @param {HTMLElement} host
 * @param {{ strong: string, text: string, cure: string | null }} work
 */
function showCure(model, host, { strong, text, cure }) {
  const send = (/** @type {string} */ kind) => () => model.send({ kind });
  const words = make("span", {}, make("b", {}, strong), ` ${text}`);
  const help = cure ? button(cure, { main: true, onClick: send("cure") }) : null;
  const buttons = [help, button(t("Close"), { onClick: send("close") })];
  const sentence = make("p", { role: "alert" }, icon(ICONS.warning), words);
  host.replaceChildren(sentence, make("div", { class: "dt-cures" }, ...buttons));
}

/**
 * For those who do not see the bar: that the robot plans, that it writes, or that it was stopped.
 */
export function tellWork(/** @type {Model} */ model, /** @type {Parts} */ parts) {
  const state = model.get("work").state;
  if (state === parts.workState) return;
  const ended = parts.workState === "working" && state === "idle";
  if (state === "working") parts.workSpoken.textContent = t("The robot plans.");
  else if (!ended) parts.workSpoken.textContent = "";
  else if (parts.stopped) parts.workSpoken.textContent = t("The robot stopped.");
  else parts.workSpoken.textContent = t("The robot has its plan and writes.");
  parts.workState = state;
  parts.stopped = false;
}

function stepList(/** @type {Work} */ work) {
  return make("ol", { class: "dt-steps" }, ...work.steps.map((words, i) => step(work, words, i)));
}

/**
 * @param {Work} work
 * @param {string} words
 * @param {number} i
 */
function step({ at, fraction }, words, i) {
  if (i < at) {
    const tick = change(icon(ICONS.tick), { class: "dt-done" });
    return make("li", {}, tick, make("span", {}, words), make("span", {}, t("yes")));
  }
  const drawing = icon(i === at ? ICONS.arrow : ICONS.later);
  const percent = Math.round(100 * fraction);
  const figure = make("span", {}, i === at ? `${percent} %` : "");
  const item = make("li", {}, drawing, make("span", {}, words), figure);
  if (i > at) return item;
  const bar = make(
    "div",
    {
      class: "dt-bar",
      role: "progressbar",
      "aria-label": words,
      "aria-valuemin": 0,
      "aria-valuemax": 100,
      "aria-valuenow": percent,
    },
    make("div", { style: `width:${100 * fraction}%` }),
  );
  item.append(bar);
  return change(item, { "aria-current": "step" });
}
