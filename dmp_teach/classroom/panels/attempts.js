// What a try is worth: a row for each of its sides, and all tries in order.

import { make } from "../../views/dom.js";
import { t } from "../../views/texts.js";
import { spoken } from "./controls.js";
import { strokesOf } from "./robot.js";
import { robotStrokes } from "./robot_sheet.js";
import { writingSheet } from "./sheets.js";

/** @typedef {import("../../views/dom.js").Model} Model */
/** @typedef {{ rows: HTMLElement, strip: HTMLElement }} Results */
/** @typedef {{ name: string, level: number, word: string, reason: string }} Side */
/** @typedef {{ number: number, mm: string, word: string, counts: number[] }} Try */

export function results() {
  const rows = { class: "dt-rows", "aria-label": t("How near it is"), hidden: true };
  const strip = { class: "dt-tries", "aria-label": t("Your tries, in order") };
  return { rows: make("ul", rows), strip: make("ol", strip) };
}

/** Four rows: what, four circles, a word, a reason. */
export function drawRows(/** @type {Model} */ model, /** @type {Results} */ parts) {
  /** @type {Side[]} */
  const rows = model.get("parts");
  // Between two tries their place stays: nothing jumps.
  const waits = !rows.length && model.get("tries").length > 0;
  parts.rows.style.minHeight = waits ? `${parts.rows.offsetHeight}px` : "";
  parts.rows.hidden = !rows.length && !waits;
  const items = rows.map(({ name, level, word, reason }) => {
    const because = make("span", { class: "dt-reason" }, reason);
    return make("li", {}, make("span", {}, name), circles(level), make("b", {}, word), because);
  });
  parts.rows.replaceChildren(...items);
}

function circles(/** @type {number} */ level) {
  const all = [0, 1, 2, 3].map((i) => {
    const look = i <= level ? "dt-full" : "dt-open";
    return make("circle", { class: look, cx: 12 + 24 * i, cy: 12, r: 9 });
  });
  return make("svg", { viewBox: "0 0 96 24", "aria-hidden": "true" }, ...all);
}

export function drawTries(/** @type {Model} */ model, /** @type {Results} */ parts) {
  /** @type {Try[]} */
  const tries = model.get("tries");
  const [box, lines] = [model.get("sheet"), model.get("lines")];
  parts.strip.hidden = !tries.length;
  const counts = tries.flatMap((each) => each.counts);
  const left = strokesOf(model, "tried", counts);
  const line = robotStrokes(model, "model");
  const items = tries.map(({ number, mm, word, counts: own }) => {
    const sheet = writingSheet({ small: true });
    const title = t("Try {number}, {mm} mm from the robot’s letter.", { number, mm: spoken(mm) });
    sheet.draw({ box, lines, dots: left.splice(0, own.length), line, title });
    const distance = make("span", {}, t("{n} mm", { n: mm }));
    const name = make("b", {}, t("Try {number}", { number }));
    const caption = make("div", { class: "dt-caption" }, name, distance);
    return make("li", {}, caption, sheet.node, make("span", {}, word));
  });
  parts.strip.replaceChildren(...items);
}
