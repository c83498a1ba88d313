// What the pad shows when the pen is lifted: the next stroke as a ghost, strokes that the robot
// wrote for the child, and why a stroke was missed.

import { t } from "../../views/texts.js";
import { strokesOf } from "./robot.js";
import { endShow, robotStrokes } from "./robot_sheet.js";
import { momentOf, playLetter } from "./sheets.js";

/** @typedef {import("../../views/dom.js").Model} Model */
/** @typedef {import("./layout.js").Place} Place */
/**
 * @typedef {import("./robot_sheet.js").SheetParts & {
 *   sheet: ReturnType<typeof import("./sheets.js").writingSheet>, why: HTMLElement,
 * }} LiftParts parts of the pad
 */
/**
 * @typedef {{
 *   ghost?: Place[], robots?: number[], missed?: { expected: number, times: number[] } | null,
 * }} Lift as Python describes it
 */

const CALM = "(prefers-reduced-motion: reduce)";
const STILLS = 4;
// [s] So long the two strokes are at least under way, and then seen whole.
const LEAST_WAY = 2;
const SEEN_WHOLE = 0.8;

/**
 * What lies on the child's sheet: its own ink, the robot's strokes in it, and the ghost.
 * @param {Model} model
 * @param {Place[][]} written
 */
export function inkOnSheet(model, written) {
  /** @type {Lift} */
  const { ghost = [], robots = [], missed } = model.get("lift");
  const rest = ghost.length ? [ghost] : [];
  const stay = rest.length && missed ? written.slice(0, -1) : written;
  return {
    dots: written.filter((_, i) => !robots.includes(i)),
    line: robots.map((i) => written[i]).filter(Boolean),
    rest,
    numbered: [...stay, ...rest],
  };
}

export function drawWhy(/** @type {Model} */ model, /** @type {LiftParts} */ parts) {
  parts.why.hidden = !model.get("lift").missed;
}

/**
 * Play the stroke that was expected and the one that was written, side by side on one clock: as the
 * hand wrote, or slower where that was too quick to see. People who ask for less movement get a
 * moment a press.
 * @param {Model} model
 * @param {LiftParts} parts
 */
export function playWhy(model, parts) {
  /** @type {Lift} */
  const { missed } = model.get("lift");
  if (!missed) return;
  const still = parts.playing?.still ?? -1;
  endShow(parts);
  const stroke = robotStrokes(model, "model")[missed.expected];
  const [begin, ...later] = model.get("model_times")[missed.expected];
  const ways = [
    { sheet: parts.sheet, stroke: strokesOf(model, "ink").at(-1), times: missed.times },
    {
      sheet: parts.robotPaper,
      stroke,
      times: [0, ...later.map((/** @type {number} */ time) => time - begin)],
    },
  ];
  const end = Math.max(...ways.map(({ times }) => times.at(-1)));
  const title = t("The stroke that was expected, and yours.");
  const draw = (/** @type {number} */ moment) => {
    for (const [i, { sheet, stroke: points, times }] of ways.entries()) {
      const { line: grown, ...scene } = momentOf([points], [times], moment);
      /** @type {Place[][]} */
      const none = [];
      const ink = i ? { dots: none, line: grown } : { dots: grown, line: none };
      const [box, lines] = [model.get("sheet"), model.get("lines")];
      sheet.draw({ box, lines, title, ...scene, ...ink });
    }
  };
  if (matchMedia(CALM).matches) {
    const at = (still + 1) % STILLS;
    draw((end * (at + 1)) / STILLS);
    parts.playing = { stop: () => {}, still: at };
    return;
  }
  const done = () => {
    endShow(parts);
    parts.drawPad();
  };
  const way = Math.max(LEAST_WAY, end);
  const drawAt = (/** @type {number} */ moment) => draw((moment * end) / way);
  parts.playing = { stop: playLetter([[way + SEEN_WHOLE]], drawAt, done) };
  parts.root.setAttribute("data-dt-showing", "true");
  parts.robotCaption.textContent = t("watch where it starts, and yours beside it");
}
