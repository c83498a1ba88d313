// A lesson whose sheet is a writing pad: what is written there is shown to the robot.

import { change, hear, make } from "../../views/dom.js";
import { t } from "../../views/texts.js";
import { told } from "../../views/told.js";
import { LessonView, renderLesson } from "../lesson/lesson.js";
import { button, ICONS, icon } from "../panels/controls.js";
import { inkCanvas } from "../panels/ink.js";
import { pixels } from "../panels/paper.js";

/** @typedef {import("../../views/dom.js").Model} Model */
/** @typedef {import("../panels/layout.js").Place} Place */

/** @param {import("../../views/dom.js").Widget} widget */
function renderTeaching(widget) {
  return renderLesson(widget, (lesson) => addPad(widget.model, lesson));
}

/**
 * Lay a pad on the sheet, and put its buttons on the card and beside what the robot says.
 * @param {Model} model
 * @param {LessonView} lesson
 */
function addPad(model, lesson) {
  const { paper } = lesson.stage;
  // What is taught stays with the kernel.
  lesson.isKept = false;
  /** @type {Place[][]} strokes that Python has not drawn yet */
  let pending = [];
  const waiting = make("g");
  const penHost = make("g");
  paper.node.append(waiting, penHost);
  const drawPending = () => {
    const d = (/** @type {Place[]} */ places) => `M${pixels(places, paper.view()).join("L")}`;
    waiting.replaceChildren(
      ...pending.map((places) => make("path", { class: "dt-child-dots", d: d(places) })),
    );
  };
  const tell = (/** @type {string} */ words) => {
    lesson.parts.status.textContent = words;
  };
  const ink = inkCanvas({
    view: () => paper.view(),
    home: () => model.get("teaching").home,
    onBegin: () => tell(""),
    onLost: tell,
    onKeys: (pen, words) => {
      const [cx, cy] = pen ? paper.view().px(pen.at) : [0, 0];
      const look = { class: pen?.down ? "dt-pen dt-down" : "dt-pen", cx, cy, r: 7 };
      penHost.replaceChildren(...(pen ? [make("circle", look)] : []));
      tell(words);
    },
    onStroke: (rows, pointer, outside) => {
      pending.push(rows.map(([, x, y]) => [x, y]));
      drawPending();
      lesson.send({ kind: "stroke", pointer, outside }, new Float64Array(rows.flat()).buffer);
    },
  });
  const sheet = make("div", { class: "dt-teach-sheet" });
  paper.node.replaceWith(sheet);
  sheet.append(paper.node, ink.node);
  const ask = (/** @type {string} */ kind) => () => lesson.send({ kind });
  const show = button(t("Show it"), { main: true, onClick: ask("show") });
  const book = button(t("Show the book’s"), { onClick: ask("book") });
  const undo = button(t("Undo"), { drawing: icon(ICONS.back), onClick: ask("undo") });
  const yes = button(t("Yes"), { onClick: ask("yes") });
  const no = button(t("No"), { onClick: ask("no") });
  lesson.parts.card.buttons.prepend(show, book, undo);
  const answers = make("span", { class: "dt-teach-answers" }, yes, no);
  lesson.parts.says.node.append(answers);
  const draw = () => {
    const { is_open, asks, strokes, letter } = model.get("teaching");
    pending = [];
    drawPending();
    for (const node of [ink.node, show, book, undo]) node.hidden = !is_open;
    answers.hidden = !asks;
    change(undo, { "aria-disabled": strokes ? null : "true" });
    const how = t(
      "Write {letter} with finger, pen or mouse; or with keys: " +
        "Space puts the pen down and lifts it, arrows move it, with Shift further, " +
        "Home goes to the start.",
      { letter },
    );
    ink.node.setAttribute("aria-label", how);
  };
  hear(model, { drawing: draw });
  draw();
}

export default told(renderTeaching);
