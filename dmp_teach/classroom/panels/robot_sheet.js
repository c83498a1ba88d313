// The robot's sheet of the pad: its own letter, which it can show as a teacher does, or what it has
// learned.

import { change, choice, make } from "../../views/dom.js";
import { t, tn } from "../../views/texts.js";
import { button, ICONS, icon, put } from "./controls.js";
import { letRobotWrite, strokesOf } from "./robot.js";
import { momentOf, playLetter, stillsOf, turnFor, writingSheet } from "./sheets.js";

/** @typedef {import("../../views/dom.js").Model} Model */
/** @typedef {import("./layout.js").Place} Place */
/**
 * @typedef {import("./robot.js").Parts & {
 *   root: HTMLElement, table: HTMLElement, drawPad(): void, strokes?: number,
 *   robotPaper: ReturnType<typeof writingSheet>, robotCaption: HTMLElement, robotHint: HTMLElement,
 *   show: HTMLElement, seen: string, robotView(value: string): void,
 *   playing?: { stop(): void, still?: number } | null,
 * }} SheetParts parts of the pad; `playing` is the letter that is being shown
 */

const CALM = "(prefers-reduced-motion: reduce)";

/** Where the robot shows its own letter, or what it has learned. */
export function robotSheet(/** @type {Model} */ model, /** @type {SheetParts} */ parts) {
  const sheet = writingSheet({ turn: turnFor(model.get("hand")) });
  const caption = make("p", { class: "dt-told", role: "status" });
  const show = button(t("Show it"), { main: true, onClick: () => showIt(model, parts) });
  const letItWrite = () => {
    parts.table.hidden = false;
    letRobotWrite(model, parts);
  };
  const drawing = icon(ICONS.pen);
  const write = button(t("Robot, write it"), { drawing, onClick: letItWrite });
  const options = [
    { value: "model", label: t("its own"), name: t("The robot’s own letter") },
    { value: "copy", label: t("learned"), name: t("What the robot has learned from you") },
  ];
  const robotView = (/** @type {string} */ value) => {
    endShow(parts);
    parts.seen = value;
    views.show(value);
    parts.drawPad();
  };
  const legend = t("The robot’s sheet shows");
  const views = choice({ legend, options, value: "model", onChange: robotView });
  const robotHint = make("span");
  const hint = make("p", { class: "dt-hint" }, robotHint);
  const title = make("b", {}, t("The robot’s letter"));
  const stack = make("div", { class: "dt-sheet" }, sheet.node, hint, caption);
  const right = make(
    "div",
    {},
    make("div", { class: "dt-caption" }, title, views.node),
    stack,
    make("div", { class: "dt-hands" }, show, write),
  );
  const robot = { robotPaper: sheet, robotCaption: caption, robotHint, robotView, seen: "model" };
  return { right, ...robot, show, write };
}

/**
 * The robot's sheet shows its own letter, with somebody's dots on it once they are all there: of
 * that the number speaks. Without a letter of its own it shows what it has learned.
 */
export function turnTheSheet(/** @type {Model} */ model, /** @type {SheetParts} */ parts) {
  const strokes = model.get("counts").length;
  if (!strokes && parts.strokes) parts.robotView("model");
  if (strokes > (parts.strokes ?? 0) && !model.get("unfinished")) {
    parts.robotView(model.get("character") ? "model" : "copy");
  }
  parts.strokes = strokes;
}

/** The strokes of "model", the robot's own letter, or of "robot", what it has learned. */
export function robotStrokes(/** @type {Model} */ model, /** @type {"model" | "robot"} */ name) {
  if (name === "robot") return strokesOf(model, name, model.get("robot_counts"));
  const counts = model.get("model_times").map((/** @type {number[]} */ times) => times.length);
  return strokesOf(model, name, counts);
}

export function drawRobot(/** @type {Model} */ model, /** @type {SheetParts} */ parts) {
  const own = parts.seen === "model";
  const learned = model.get("counts").length > 0;
  const line = own || learned ? robotStrokes(model, own ? "model" : "robot") : [];
  const dots = own ? laidOn(model, line) : strokesOf(model, "ink");
  const caption = own ? t("with your dots on it") : t("learned from your dots");
  put(parts.robotCaption, dots.length ? caption : "");
  const hint = own
    ? t("Choose a letter, and the robot shows it")
    : t("The robot learns from what you write");
  parts.robotHint.textContent = line.length ? "" : hint;
  const character = model.get("character");
  const name = own
    ? t("The robot’s own {letter}", { letter: character })
    : t("What the robot learned from you");
  const count = tn("{n} stroke", "{n} strokes", line.length);
  const title = line.length ? `${name}, ${count}.` : t("The robot’s sheet is empty.");
  const [box, lines] = [model.get("sheet"), model.get("lines")];
  parts.robotPaper.draw({ box, lines, dots, line, numbered: line, title });
  change(parts.show, { "aria-disabled": character ? null : "true" });
}

/**
 * The child's ink once it is all there, laid on the robot's own letter as the number compares them.
 */
function laidOn(/** @type {Model} */ model, /** @type {Place[][]} */ line) {
  const [right, up] = model.get("shift");
  if (right === undefined || !line.length) return [];
  return strokesOf(model, "ink").map((points) => points.map(([x, y]) => [x + right, y + up]));
}

/**
 * The robot is the teacher: its letter grows at its own tempo; people who ask for less movement get
 * stills.
 * @param {Model} model
 * @param {SheetParts} parts
 */
function showIt(model, parts) {
  const character = model.get("character");
  if (!character) return;
  const [strokes, times] = [robotStrokes(model, "model"), model.get("model_times")];
  const still = parts.playing?.still ?? -1;
  parts.robotView("model");
  const [box, lines] = [model.get("sheet"), model.get("lines")];
  const title = t("The robot writes its {letter}.", { letter: character });
  const draw = (/** @type {number} */ moment) => {
    const written = momentOf(strokes, times, moment);
    parts.robotPaper.draw({ box, lines, dots: [], title, ...written });
  };
  if (matchMedia(CALM).matches) {
    showStill(parts, draw, stillsOf(times), still + 1);
    return;
  }
  draw(0);
  const done = () => {
    endShow(parts);
    parts.drawPad();
  };
  parts.playing = { stop: playLetter(times, draw, done) };
  parts.root.setAttribute("data-dt-showing", "true");
  parts.robotCaption.textContent = t("watch where it starts");
}

/**
 * One picture a press: the letter so far.
 * @param {SheetParts} parts
 * @param {(moment: number) => void} draw
 * @param {number[]} stills
 * @param {number} number
 */
function showStill(parts, draw, stills, number) {
  const at = number % stills.length;
  draw(stills[at]);
  parts.playing = { stop: () => {}, still: at };
  parts.show.querySelector("span").textContent = t("Next picture");
  parts.robotCaption.textContent = t("picture {n} of {count}", {
    n: at + 1,
    count: stills.length,
  });
}

export function endShow(/** @type {SheetParts} */ parts) {
  parts.playing?.stop();
  parts.playing = null;
  parts.show.querySelector("span").textContent = t("Show it");
  parts.root.removeAttribute("data-dt-showing");
}
