// The pictures of a lesson: the sheet at the left, plots and the robot at the right, and the bet
// that is drawn on one of them.

import { choice, make } from "../../views/dom.js";
import { t } from "../../views/texts.js";
import { Plot } from "../panels/plot.js";
import { LessonPaper } from "./lesson_paper.js";
import { resolve } from "./pictures.js";

/** @typedef {Record<string, any>} Values */

export class Stage {
  /**
   * @param {Values} spec
   * @param {{ table: HTMLElement }} robot
   * @param {{
   *   onBet(bet: number[][]): void, onValues(changes: Values, isDone: boolean): void,
   *   onShort(words: string): void,
   * }} listeners
   */
  constructor(spec, robot, listeners) {
    this.spec = spec;
    this.listeners = listeners;
    this.table = robot.table;
    /**
     * @type {Record<
     *   string, { node: HTMLElement, plot: Plot, words: ReturnType<typeof captionOf> }
     * >}
     */
    this.plots = {};
    /** @type {number[][] | null} the bet in the hand, where it is drawn */
    this.bet = null;
    this.isMoved = false;
    this.isKept = false;
    this.isRevealed = false;
    this.isBetting = true;
    this.picture = {};
    this.values = {};
    const moveHandle = (
      /** @type {number} */ i,
      /** @type {number[]} */ place,
      /** @type {boolean} */ isDone,
    ) => this.moveHandle(i, place, isDone);
    const moveRing = (
      /** @type {number} */ i,
      /** @type {number[]} */ place,
      /** @type {boolean} */ isDone,
    ) => this.moveRing(i, place, isDone);
    this.paper = new LessonPaper({
      onPick() {},
      onHome: (/** @type {number} */ i) => this.moveRing(i, this.rings[i].home, true),
      onGoal: moveRing,
      onHandle: moveHandle,
      onShort: () => {
        const words = t("Please draw the whole line.");
        this.caption.show(words);
        this.listeners.onShort(words);
      },
    });
    this.caption = captionOf();
    this.left = make("div", { class: "dt-left" }, this.caption.node, this.paper.node);
    this.column = make("div", { class: "dt-plots" });
    this.table.hidden = true;
    this.views = choice({
      legend: t("What to look at"),
      kind: "dt-choice dt-views",
      options: [
        { value: "plots", label: t("How it works") },
        { value: "robot", label: t("The robot") },
      ],
      onChange: (which) => this.showRobot(which === "robot"),
    });
    this.views.node.hidden = true;
    this.right = make("div", { class: "dt-right" }, this.column, this.table);
    this.node = make("div", { class: "dt-stage" }, this.left, this.right);
    /** @type {any[]} */
    this.rings = [];
  }

  /** Show the robot's table in the place of the plots; from then on one may choose. */
  showRobot(/** @type {boolean} */ isSeen) {
    if (isSeen) this.views.node.hidden = false;
    this.table.hidden = !isSeen;
    this.column.hidden = isSeen;
    this.views.show(isSeen ? "robot" : "plots");
  }

  take(/** @type {Values} */ progress) {
    const { bet } = this.spec;
    this.isBetting = progress.step === "bet" && !progress.revealed;
    this.isRevealed = progress.revealed;
    if (!bet.handles) return;
    if (Array.isArray(progress.bet)) {
      this.bet = progress.bet;
      this.isMoved = true;
    } else if (!this.bet || !this.isBetting || this.isKept) {
      // What was kept is forgotten; a bet in the hand stays.
      this.bet = bet.handles;
      this.isMoved = false;
    }
    this.isKept = Array.isArray(progress.bet);
  }

  /**
   * @param {number} i
   * @param {number[]} place
   * @param {boolean} isDone
   */
  moveHandle(i, place, isDone) {
    this.bet = this.bet.map((each, j) => (j === i ? place : each));
    this.isMoved = true;
    this.draw(this.picture, this.values);
    if (isDone) this.listeners.onBet(this.bet);
  }

  /**
   * @param {number} i
   * @param {number[]} place
   * @param {boolean} isDone
   */
  moveRing(i, place, isDone) {
    const { knobs, home, zero = home, scale } = this.rings[i];
    /** @type {Values} */
    const changes = {};
    for (const [axis, name] of knobs.entries()) {
      const { low, high, step } = this.spec.knobs[name];
      const value = Math.round((place[axis] - zero[axis]) / scale / step) * step;
      changes[name] = Number(Math.min(Math.max(value, low), high).toFixed(6));
    }
    this.listeners.onValues(changes, isDone);
  }

  draw(/** @type {Values} */ picture, /** @type {Values} */ values) {
    this.picture = picture;
    this.values = values;
    const { sheet, plots } = resolve(picture, values, this.spec.knobs);
    this.left.hidden = !sheet;
    if (sheet) this.drawSheet(sheet);
    for (const [name, drawing] of Object.entries(plots ?? {})) this.drawPlot(name, drawing);
    for (const name of Object.keys(this.plots)) this.plots[name].node.hidden = !plots[name];
  }

  drawSheet(/** @type {Values} */ sheet) {
    this.caption.show(sheet.caption, sheet.note);
    // A home that follows knobs comes as points.
    this.rings = (sheet.rings ?? []).map((/** @type {any} */ ring) => ({
      ...ring,
      home: ring.home.flat(),
    }));
    this.paper.sheet(sheet.box);
    this.paper.draw({
      title: "",
      demo: [],
      robot: [],
      stroke: 0,
      ...this.handlesOf("sheet"),
      ...sheet,
      taught: this.rings.map(({ home, at, isFree }) => (isFree ? at[0] : home)),
      goals: this.rings.map(({ at }) => at[0]),
      names: this.rings.map(({ label, at, knobs, scale, word }) => ({
        ...{ label, word, now: 0, text: spokenPlace(at[0]), isFixed: !knobs.length },
        step: knobs.length ? scale * this.spec.knobs[knobs[0]].step : undefined,
      })),
    });
  }

  drawPlot(/** @type {string} */ name, /** @type {Values} */ drawing) {
    const { caption, note, hides_bet, ...scene } = drawing;
    let one = this.plots[name];
    if (!one) {
      const words = captionOf();
      const plot = new Plot({
        onHandle: (i, place, isDone) => this.moveHandle(i, place, isDone),
        onThreshold: (knob, value, isDone) => this.listeners.onValues({ [knob]: value }, isDone),
      });
      const node = make("div", { class: `dt-plot-box dt-plot-${name}` }, words.node, plot.node);
      one = { node, plot, words };
      this.plots[name] = one;
      this.column.append(node);
    }
    one.words.show(caption, note);
    const { bet, ...handles } = this.handlesOf(name);
    const kept = bet && !hides_bet ? [{ points: bet, kind: "bet", label: t("your bet") }] : [];
    const lines = [...(scene.lines ?? []), ...kept];
    one.plot.draw(/** @type {any} */ ({ title: caption, ...scene, ...handles, lines }));
  }

  /** The handles of the bet, and afterwards its line, where it is drawn on this part. */
  handlesOf(/** @type {string} */ part) {
    const { bet } = this.spec;
    if (bet.part !== part || !this.bet) return {};
    if (!this.isBetting) return this.isMoved ? { bet: this.bet } : {};
    const handles = this.bet.map((at, i) => ({
      at,
      first: bet.handles[i],
      label: bet.labels[i],
      text: bet.unit ? `${Number(at[1].toPrecision(2))} ${bet.unit}` : spokenPlace(at),
      axis: bet.axis,
      step: bet.step,
    }));
    return { handles };
  }
}

const spokenPlace = (/** @type {number[]} */ [x, y]) =>
  `${(100 * x).toFixed(1)}, ${(100 * y).toFixed(1)} cm`.replaceAll("-", "−");

/** The name of a picture, and a word about it. */
function captionOf() {
  const name = make("b");
  const note = make("span");
  const node = make("div", { class: "dt-caption" }, name, note);
  const show = (/** @type {string} */ words, more = "") => {
    name.textContent = words ?? "";
    note.textContent = more;
  };
  return { node, show };
}
