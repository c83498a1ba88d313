// How hard the pen presses, on the slider's own clock.

import { change, make, newId } from "../dom.js";
import { t } from "../texts.js";

/**
 * @typedef {{
 *   duration: number, label: string, notes: string, cameras: Record<string, any>,
 *   plan: number[][], ink: number[][], force?: Force,
 * }} Facts a motion, or what became of it; a dot of ink is its time, x, y, whether it is a
 *   stroke's first, and its shade
 */
/**
 * @typedef {{
 *   band: number[], curve: number[][], down: number[][], most: number, inked: number,
 *   verdict: string, findings: string[],
 * }} Force a point of the curve is its time, force, and the nib's x and y
 */

// [N] The scale is always the same; what is higher is written beside an arrow.
const FORCE_TOP = 1.6;
// Above and below the curve [px]: what is higher, and the bars.
const FORCE_Y = { top: 24, zero: 36, bar: 15 };
const THUMB = 14;
const SHADES = 6;

/** @returns {[number, string, string?][]} up to which force [N] what it feels like */
const feels = () => [
  [0.03, t("The pen is in the air.")],
  [0.2, t("As heavy as a pencil"), t("hardly touching")],
  [0.35, t("As heavy as a strawberry"), t("good pressing")],
  [0.8, t("As heavy as an egg"), t("good pressing")],
  [1.2, t("As heavy as an apple"), t("good pressing")],
  [4, t("As heavy as a mug"), t("too hard")],
  [12, t("As heavy as a bottle of water"), t("too hard")],
  [Infinity, t("As heavy as a bucket of water"), t("much too hard")],
];

/** The ink so far on the small page, a path for each shade of force. */
export function shadedInk() {
  const paths = Array.from({ length: SHADES }, (_, n) =>
    make("path", { class: `dts-shade dts-shade-${n}` }),
  );
  /** Draw the first dots, if they have shades; return whether they have. */
  const show = (/** @type {number[][]} */ dots, /** @type {number} */ count) => {
    const shaded = dots.length > 0 && dots[0].length > 4;
    const d = paths.map(() => "");
    for (let n = 0; shaded && n < count; n += 1) {
      const [, x, y, first, shade] = dots[n];
      const from = first ? dots[n] : dots[n - 1];
      d[shade] += `M${from[1]} ${-from[2]}L${x} ${-y}`;
    }
    for (const [n, path] of paths.entries()) path.setAttribute("d", d[n]);
    return shaded;
  };
  return { node: make("g", {}, ...paths), show };
}

/**
 * Time, force and place of the nib at a time, even from point to point of the curve.
 * @param {number[][]} curve
 * @param {number} t
 */
export function feltAt(curve, t) {
  const next = curve.findIndex(([when]) => when >= t);
  if (next <= 0) return next === 0 ? curve[0] : curve[curve.length - 1];
  const part = (t - curve[next - 1][0]) / (curve[next][0] - curve[next - 1][0]);
  return curve[next].map((value, n) => curve[next - 1][n] + part * (value - curve[next - 1][n]));
}

/**
 * What a force feels like: [words, verdict]; in the air there is no verdict.
 * @param {number} force [N]
 * @param {boolean} mustWrite whether the pen is meant to be down
 */
export function feelOf(force, mustWrite) {
  const [, feel, verdict] = feels().find(([most]) => force < most);
  return !verdict && mustWrite ? [t("The pen does not reach the paper.")] : [feel, verdict];
}

/**
 * The strip under the slider: force, good pressing, when the pen was meant to be down, and the
 * moment itself.
 */
export class ForceStrip {
  /** @param {HTMLInputElement} slider the playhead stands under its thumb */
  constructor(slider) {
    this.slider = slider;
    /** @type {Force | null} */
    this.force = null;
    this.duration = 0;
    this.time = 0;
    this.left = 0;
    this.right = 1;
    this.height = 140;
    const id = newId("force");
    const shape = (/** @type {string} */ name, more = {}) =>
      make("path", { class: `dts-f-${name}`, ...more });
    const text = (/** @type {string} */ name, words = "") =>
      make("text", { class: `dts-f-${name}` }, words);
    const done = { "clip-path": `url(#${id})` };
    this.band = make("rect", { class: "dts-f-band" });
    this.edges = shape("edges");
    this.zero = shape("zero");
    this.rest = shape("rest");
    this.bars = shape("bars");
    this.done = shape("done", done);
    this.barsDone = shape("bars-done", done);
    this.head = shape("head");
    this.dot = make("circle", { class: "dts-f-dot", r: 7 });
    this.clip = make("rect", { y: 0, x: 0, height: 200 });
    this.labels = {
      high: text("label"),
      low: text("label"),
      down: text("label", t("pen down")),
      good: text("good", t("good pressing")),
    };
    this.peak = text("peak");
    this.now = text("now");
    const marks = [this.band, this.edges, this.zero, ...Object.values(this.labels), this.rest];
    marks.push(this.bars, this.done, this.barsDone, this.peak, this.head, this.dot, this.now);
    const clip = make("clipPath", { id }, this.clip);
    this.svg = make("svg", { class: "dts-strip", role: "img" }, clip, ...marks);
    this.newtons = make("b", { class: "dts-newtons" });
    this.says = make("span");
    this.findings = make("ul", { class: "dts-findings" });
    this.node = make(
      "section",
      { class: "dts-force", hidden: true },
      make("p", { class: "dts-force-title" }, make("b", {}, t("How hard the pen presses"))),
      this.svg,
      make("p", { class: "dts-feels" }, this.newtons, this.says),
      this.findings,
    );
  }

  x(/** @type {number} */ time) {
    const part = this.duration ? time / this.duration : 0;
    return this.left + part * (this.right - this.left);
  }

  y(/** @type {number} */ force) {
    const part = Math.min(force, FORCE_TOP) / FORCE_TOP;
    const zero = this.height - FORCE_Y.zero;
    return zero - part * (zero - FORCE_Y.top);
  }

  load(/** @type {Facts} */ facts) {
    this.force = facts.force ?? null;
    this.duration = facts.duration;
    this.node.hidden = !this.force;
    if (!this.force) return;
    const { verdict, findings } = this.force;
    this.svg.setAttribute("aria-label", `${t("How hard the pen presses")}. ${verdict}`);
    this.findings.replaceChildren(...findings.map((words) => make("li", {}, words)));
    this.findings.hidden = !findings.length;
    this.draw();
  }

  /** Lay it out again: the playhead must stand under the slider's thumb. */
  draw() {
    const [box, bar] = [this.svg.getBoundingClientRect(), this.slider.getBoundingClientRect()];
    if (!this.force || !box.width || !bar.width) return;
    [this.left, this.right] = [bar.left + THUMB - box.left, bar.right - THUMB - box.left];
    this.height = box.height;
    this.svg.setAttribute("viewBox", `0 0 ${box.width} ${box.height}`);
    this.drawScale(box.width);
    this.drawCurve();
    this.show(this.time);
  }

  drawScale(/** @type {number} */ width) {
    const { left, right, labels } = this;
    const [low, high] = this.force.band;
    const [top, bottom] = [this.y(high), this.y(low)];
    change(this.band, { x: left, y: top, width: right - left, height: bottom - top });
    this.edges.setAttribute("d", `M${left} ${bottom}H${right}M${left} ${top}H${right}`);
    this.zero.setAttribute("d", `M${left} ${this.y(0)}H${right}`);
    labels.high.textContent = t("{n} N", { n: high });
    labels.low.textContent = t("{n} N", { n: low });
    put(labels.high, left - 10, top + 5, "end");
    put(labels.low, left - 10, bottom + 5, "end");
    put(labels.down, left - 10, this.height - FORCE_Y.bar + 5, "end");
    if (width - right > 96) put(labels.good, right + 10, (bottom + top) / 2 + 5, "start");
    else put(labels.good, right - 6, top + 16, "end");
  }

  drawCurve() {
    const { curve, down, most } = this.force;
    const places = curve.map(([t, force]) => `${this.x(t).toFixed(1)} ${this.y(force).toFixed(1)}`);
    const bar = this.height - FORCE_Y.bar;
    const bars = down.map(([from, to]) => `M${this.x(from)} ${bar}H${this.x(to)}`).join("");
    for (const path of [this.rest, this.done]) path.setAttribute("d", `M${places.join("L")}`);
    for (const path of [this.bars, this.barsDone]) path.setAttribute("d", bars);
    const worst = curve.reduce((a, b) => (b[1] > a[1] ? b : a));
    this.peak.textContent = worst[1] > FORCE_TOP ? `↑ ${t("{n} N", { n: most })}` : "";
    const at = this.x(worst[0]);
    const near = at > this.right - 80;
    put(this.peak, at + (near ? -8 : 8), FORCE_Y.top - 8, near ? "end" : "start");
  }

  show(/** @type {number} */ time) {
    this.time = time;
    if (!this.force) return;
    const { curve, down, verdict } = this.force;
    const [, force] = feltAt(curve, time);
    const [x, y] = [this.x(time), this.y(force)];
    const newtons = force.toFixed(force < 10 ? 1 : 0);
    this.clip.setAttribute("width", String(Math.max(0, x)));
    this.head.setAttribute("d", `M${x} 2V${this.height - 4}`);
    change(this.dot, { cx: x, cy: y });
    this.now.textContent = t("{n} N", { n: newtons });
    const near = x > this.right - 64;
    const above = Math.max(y - 10, FORCE_Y.top + 16);
    put(this.now, x + (near ? -14 : 14), above, near ? "end" : "start");
    this.newtons.replaceChildren(newtons, make("small", {}, " N"));
    const mustWrite = down.some(([from, to]) => from <= time && time <= to);
    const [feel, pressing] = feelOf(force, mustWrite);
    const felt = pressing ? [`${feel}: `, make("b", {}, pressing), ". "] : [`${feel} `];
    this.says.replaceChildren(...felt, verdict);
  }
}

/**
 * @param {SVGTextElement} node
 * @param {number} x
 * @param {number} y
 * @param {"start" | "end"} anchor
 */
function put(node, x, y, anchor) {
  change(node, { x, y, "text-anchor": anchor });
}
