// The small page in the picture's corner, with the ink so far.

import { change, make } from "../dom.js";
import { t } from "../texts.js";
import { feltAt, shadedInk } from "./force.js";

/** @typedef {import("./force.js").Facts} Facts */

const step = (/** @type {number[]} */ [, x, y, first]) => `${first ? "M" : "L"}${x} ${-y}`;

export class SmallPage {
  constructor() {
    this.plan = make("path", { class: "dts-plan" });
    this.ink = make("path", { class: "dts-ink" });
    this.pen = make("circle", { class: "dts-pen" });
    this.shades = shadedInk();
    const all = [this.plan, this.ink, this.shades.node, this.pen];
    this.svg = make("svg", { "aria-hidden": "true" }, ...all);
    this.share = make("span", {}, "0 %");
    const head = make("div", {}, make("b", {}, t("Ink so far")), this.share);
    this.node = make("div", { class: "dts-inset" }, head, this.svg);
    /** @type {number[][]} */
    this.dots = [];
    /** @type {number[][] | undefined} */
    this.curve = undefined;
    this.percent = 100;
  }

  load(/** @type {Facts} */ { ink, plan, force }) {
    this.dots = ink;
    this.curve = force?.curve;
    // Of the letter this has ink in the end.
    this.percent = 100 * (force?.inked ?? 1);
    const all = [...plan, ...ink];
    this.node.hidden = !all.length;
    if (!all.length) return;
    const [xs, ys] = [all.map((dot) => dot[1]), all.map((dot) => -dot[2])];
    const [left, top] = [Math.min(...xs), Math.min(...ys)];
    const [wide, high] = [Math.max(...xs) - left, Math.max(...ys) - top];
    const side = 1.25 * Math.max(wide, high, 20);
    const [x, y] = [left + (wide - side) / 2, top + (high - side) / 2];
    this.svg.setAttribute("viewBox", `${x} ${y} ${side} ${side}`);
    this.svg.style.setProperty("--one", String(side / 100));
    this.pen.setAttribute("r", String(side / 36));
    this.plan.setAttribute("d", plan.map(step).join(""));
  }

  show(/** @type {number} */ time) {
    const { dots, curve } = this;
    const next = dots.findIndex(([when]) => when > time + 1e-6);
    const count = next < 0 ? dots.length : next;
    const shaded = this.shades.show(dots, count);
    this.ink.setAttribute("d", shaded ? "" : dots.slice(0, count).map(step).join(""));
    const last = dots[Math.max(0, count - 1)] ?? [0, 0, 0];
    const [cx, y] = curve ? feltAt(curve, time).slice(2) : last.slice(1);
    change(this.pen, { cx, cy: -y });
    const share = dots.length ? (this.percent * count) / dots.length : 0;
    this.share.textContent = `${Math.round(share)} %`;
  }
}
