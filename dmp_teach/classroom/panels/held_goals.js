// Goals that a hand moves: the robot's line follows them here, at once; the kernel hears of a goal
// once, where it was let go.

import { once } from "../../views/dom.js";
import { affinePoints, unpack } from "./affine.js";
import { cut, strokesOf } from "./robot.js";

/** @typedef {import("../../views/dom.js").Model} Model */
/** @typedef {import("./layout.js").Place} Place */

export class HeldGoals {
  /**
   * @param {Model} model
   * @param {{ ask(changes: Record<string, any>): void, draw(): void }} listeners
   */
  constructor(model, { ask, draw }) {
    this.model = model;
    this.ask = ask;
    this.draw = draw;
    /** @type {{ letter: string, goal_shifts: number[][], stroke: number } | null} */
    this.held = null;
    this.demoOf = once((/** @type {DataView} */ _, /** @type {number[]} */ counts) =>
      strokesOf(model, "demo", counts),
    );
    this.taughtOf = once((/** @type {Place[][]} */ demo) =>
      demo.map((points) => points[points.length - 1]),
    );
    this.placesOf = once((/** @type {Place[]} */ taught, /** @type {number[][]} */ shifts) =>
      taught.map(([x, y], i) => [x + shifts[i][0], y + shifts[i][1]]),
    );
  }

  /**
   * What is seen: what is in the hand, or what the kernel was told.
   * @returns {{ goal_shifts: number[][], stroke: number }}
   */
  get now() {
    const { held, model } = this;
    if (held?.letter === model.get("letter")) return held;
    return { goal_shifts: model.get("goal_shifts"), stroke: model.get("stroke") };
  }

  get isHeld() {
    return this.now === this.held;
  }

  /** Whether the line is ahead of what the kernel has said of it. */
  get isAhead() {
    return String(this.now.goal_shifts) !== String(this.model.get("drawn_shifts"));
  }

  /** The strokes of the person. */
  get demo() {
    return this.demoOf(this.model.get("demo"), this.model.get("counts"));
  }

  get taught() {
    return this.taughtOf(this.demo);
  }

  get places() {
    return this.placesOf(this.taught, this.now.goal_shifts);
  }

  /** The strokes of the robot: as the kernel drew them, moved on with their goals since. */
  get line() {
    const { model, now } = this;
    const counts = model.get("counts");
    const [right, up] = ["x", "y"].map((axis) =>
      cut(unpack(model.get("goal_terms")[axis]), counts),
    );
    const drawn = model.get("drawn_shifts");
    return cut(unpack(model.get("robot"), Float32Array), counts).map((base, i) => {
      const [x, y] = now.goal_shifts[i].map((shift, axis) => shift - drawn[i][axis]);
      return affinePoints(base, { x: right[i], y: up[i] }, { x, y });
    });
  }

  /**
   * @param {number} stroke
   * @param {number[]} shift [m] from where the goal was taught
   * @param {boolean} isDone whether the hand has let it go
   */
  move(stroke, shift, isDone = false) {
    const goal_shifts = [...this.now.goal_shifts];
    goal_shifts[stroke] = shift.map((value) => Math.round(value * 1e4) / 1e4);
    this.held = { letter: this.model.get("letter"), goal_shifts, stroke };
    if (isDone) this.release();
    else this.draw();
  }

  release() {
    if (!this.isHeld) return;
    const { goal_shifts, stroke } = this.held;
    this.held = null;
    this.ask({ goal_shifts, stroke });
    this.draw();
  }
}
