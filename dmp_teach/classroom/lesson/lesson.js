// A lesson: its steps, the card of the step, the pictures, and the knobs. What a lesson shows comes
// from Python as a picture; what is drawn by hand here waits for nobody.

import { asking, choice, hear, keepKeys, make, save } from "../../views/dom.js";
import { t, useTexts } from "../../views/texts.js";
import { told } from "../../views/told.js";
import { bump, button, LOG, put, sentence, slider } from "../panels/controls.js";
import {
  asleepBox,
  drawOlder,
  letRobotWrite,
  robotTable,
  showRobot,
  watch,
} from "../panels/robot.js";
import { drawWork, tellWork } from "../panels/work.js";
import { Card } from "./card.js";
import { keptWork } from "./kept_work.js";
import { Stage } from "./stage.js";

/** @typedef {import("../../views/dom.js").Model} Model */
/** @typedef {Record<string, any>} Values */

/**
 * @param {import("../../views/dom.js").Widget} widget
 * @param {(lesson: LessonView) => void} [extend] adds what one kind of lesson has
 */
export function renderLesson({ model, el, host, signal }, extend) {
  useTexts(model.get("texts"));
  const root = keepKeys(make("div", { class: "dt-panel dt-lesson" }));
  const lesson = new LessonView(model, signal);
  const { parts } = lesson;
  extend?.(lesson);
  const { head, card, stage, middle, knobs, more } = parts;
  const body = make("div", { class: "dt-body" }, card.node, stage.node, middle, knobs);
  root.append(head, body, more);
  el.append(root);
  const redraw = () => {
    lesson.redraw();
    root.setAttribute("data-dt-drawing", model.get("drawing"));
    root.toggleAttribute("data-dt-kept", lesson.isKept);
  };
  const showScene = () => showRobot(model, host, parts.robotHost, signal);
  hear(model, {
    drawing: redraw,
    values: () => lesson.takeValues(),
    work: () => {
      if (model.get("work").state !== "idle") parts.stage.showRobot(true);
      drawWork(model, parts);
      tellWork(model, parts);
    },
    older: () => drawOlder(model, parts),
    scene: () => {
      if (!model.get("scene")) parts.stage.showRobot(false);
      showScene();
    },
    status: () => put(parts.status, model.get("status")),
  });
  const stopWatching = watch(model, root, parts);
  lesson.takeUp();
  redraw();
  drawWork(model, parts);
  drawOlder(model, parts);
  showScene();
  return stopWatching;
}

export class LessonView {
  /**
   * @param {Model} model
   * @param {AbortSignal} [signal]
   */
  constructor(model, signal) {
    this.model = model;
    this.spec = model.get("spec");
    this.work = keptWork(this.spec, () => this.send({ kind: "forget" }), signal);
    /** @type {Values} what is set, in the hand, too */
    this.values = { ...model.get("values") };
    /** whether the browser keeps all that a pupil does here */
    this.isKept = !this.spec.draws_tried;
    /** the values that the sentence is about */
    this.said = "";
    const says = sentence();
    const asleep = asleepBox(t("The robot does not answer."));
    const robot = robotTable();
    const send = (/** @type {object} */ message) => this.send(message);
    const letters = make("div");
    this.steps = choice({
      legend: t("Step of the lesson"),
      kind: "dt-choice dt-step-bar",
      options: [
        { value: "bet", label: t("1 Bet") },
        { value: "try", label: t("2 Try") },
        { value: "challenge", label: t("3 Challenge"), asks: true },
      ],
      onChange: (step) => send({ kind: "step", step }),
    });
    const write = () => {
      this.stage.showRobot(true);
      letRobotWrite(model, this.parts);
    };
    const card = new Card(this.spec, { send, write, bet: () => this.stage.bet });
    this.stage = new Stage(this.spec, robot, {
      onBet: (bet) => send({ kind: "bet", bet }),
      onValues: (changes, isDone) => this.set(changes, isDone),
      onShort: (words) => put(card.spoken, words),
    });
    const title = make("span", { class: "dt-question" }, this.spec.question);
    const head = make("div", { class: "dt-head" }, this.steps.node, this.stage.views.node, title);
    const middle = make("div", { class: "dt-says" }, says.node, asleep);
    this.knobs = knobsOf(this.spec.knobs, (name, value, isDone) =>
      this.set({ [name]: value }, isDone),
    );
    const knobs = make(
      "div",
      { class: "dt-knobs" },
      ...Object.values(this.knobs).map(({ node }) => node),
    );
    const { stage } = this;
    const status = make("span", { class: "dt-quiet", role: "status" }, model.get("status"));
    const more = make("div", { class: "dt-more" }, ...this.keepers(), status);
    /** @type {any} as `Parts` of a panel, and the lesson's own */
    this.parts = {
      head,
      card,
      stage,
      middle,
      knobs,
      more,
      status,
      says,
      asleep,
      letters,
      ...robot,
    };
    this.parts.write = card.write;
  }

  /**
   * Tell Python, if it is there; the bet and the knobs in the hand stay without it.
   * @param {object} message
   * @param {ArrayBuffer} [content]
   */
  send(message, content) {
    this.parts.waits();
    try {
      this.model.send(message, undefined, content && [content]);
    } catch (error) {
      console.warn(error);
    }
  }

  /**
   * Turn knobs. Those that are drawn here tell Python on release alone.
   * @param {Values} changes
   * @param {boolean} isDone
   */
  set(changes, isDone) {
    Object.assign(this.values, changes);
    const isHere = Object.keys(changes).every((name) => this.spec.knobs[name].is_drawn_here);
    this.drawPictures();
    if (isHere && !isDone) return;
    save(this.model, { values: { ...this.values }, asked: this.model.get("asked") + 1 });
  }

  takeValues() {
    this.values = { ...this.model.get("values") };
    this.drawPictures();
  }

  drawPictures() {
    const picture = this.model.get("picture");
    for (const [name, knob] of Object.entries(this.knobs))
      knob.show(this.values[name], picture.highs[name]);
    this.stage.draw(picture, this.values);
    this.parts.says.node.classList.toggle("dt-ahead", JSON.stringify(this.values) !== this.said);
  }

  redraw() {
    const progress = this.model.get("progress");
    this.steps.show(progress.step);
    this.parts.card.show(progress, this.model.get("card"));
    this.stage.take(progress);
    this.said = JSON.stringify(this.model.get("values"));
    this.drawPictures();
    this.parts.says.show(this.model.get("message"));
    this.parts.knobs.hidden = progress.step === "bet";
    for (const [name, { node }] of Object.entries(this.knobs))
      node.hidden = this.spec.knobs[name].is_for_try && progress.step !== "try";
    this.work.keep({ values: this.model.get("values"), progress });
  }

  /** *Save* and *Forget*; forgetting asks once more. */
  keepers() {
    const save = button(t("Save my work"), { onClick: () => this.send({ kind: "save" }) });
    const forget = button(t("Forget my work"), {
      onClick: () => {
        yes.hidden = !yes.hidden;
        if (!yes.hidden) yes.focus();
      },
    });
    const yes = button(t("Yes, forget it"), {
      onClick: () => {
        yes.hidden = true;
        this.work.forget();
        forget.focus({ preventScroll: true });
        this.parts.head.scrollIntoView();
      },
    });
    yes.hidden = true;
    return [asking(save), asking(forget), yes];
  }

  takeUp() {
    const work = this.work.read();
    if (work && this.model.get("progress").bet === null) this.send({ kind: "restore", work });
  }
}

/**
 * A slider or a bar for each knob.
 * @param {Record<string, any>} knobs
 * @param {(name: string, value: any, isDone: boolean) => void} onSet
 */
function knobsOf(knobs, onSet) {
  /** @type {Record<string, { node: HTMLElement, show(value: any, high?: number): void }>} */
  const made = {};
  for (const [name, knob] of Object.entries(knobs)) {
    if (knob.kind === "choice") {
      const options = knob.options.map((/** @type {string[]} */ [value, label]) => ({
        value,
        label,
      }));
      const bar = choice({
        legend: [knob.label, knob.note].filter(Boolean).join(": "),
        options,
        onChange: (value) => onSet(name, value, true),
      });
      const label = make("span", { class: "dt-knob-name", "aria-hidden": "true" }, knob.label);
      if (knob.note) label.append(make("small", {}, knob.note));
      made[name] = {
        node: make("div", { class: "dt-knob-choice" }, label, bar.node),
        show: bar.show,
      };
    } else made[name] = knobSlider(knob, (value, isDone) => onSet(name, value, isDone));
    if (!knob.is_drawn_here) asking(made[name].node);
  }
  return made;
}

/**
 * @param {Values} knob
 * @param {(value: number, isDone: boolean) => void} onSet
 */
function knobSlider(knob, onSet) {
  const figure = (/** @type {number} */ value) => {
    const digits = knob.digits ?? (Math.abs(value) < 1 ? 2 : Math.abs(value) < 10 ? 1 : 0);
    return value.toFixed(digits).replace("-", "−");
  };
  const text = (/** @type {number} */ value) => `${figure(value)} ${knob.unit}`.trim();
  const made = slider({
    ...{ label: knob.label, term: knob.term, low: knob.low, high: knob.high, step: knob.step },
    text,
    spoken: text,
    scale: knob.is_log ? LOG : undefined,
    icons: knob.icons?.map(bump),
    onInput: (value) => onSet(value, false),
  });
  const scale = knob.is_log ? LOG.value : Number;
  const held = () => scale(Number(made.input.value));
  made.input.addEventListener("change", () => onSet(held(), true));
  let most = knob.high;
  const show = (/** @type {number} */ value, high = knob.high) => {
    const shown = Math.min(value, high);
    // A value that comes back rounded must not pull the thumb back.
    if (held() !== shown || most !== high) made.show(shown, knob.low, high);
    most = high;
  };
  made.show(knob.low);
  return { node: made.node, show };
}

export default told(renderLesson);
