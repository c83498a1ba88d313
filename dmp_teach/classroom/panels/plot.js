// A plot over time or over a setting, in the look of the sheet. Values and words come from Python;
// everything drawn is in screen pixels, so that labels keep their size.

import { change, make, newId } from "../../views/dom.js";
import { drawAxes } from "./axes.js";
import { Handles, onDrag, WAYS } from "./handles.js";
import {
  badgesOf,
  dotsOf,
  drawBands,
  drawFills,
  drawLines,
  drawThreshold,
  labelsOf,
  placeThreshold,
} from "./marks.js";
import { within } from "./scales.js";

/** @typedef {import("./layout.js").Place} Place */
/** @typedef {import("./scales.js").Axis} Axis */
/** @typedef {import("./handles.js").Handle} Handle */
/** @typedef {"robot" | "child" | "bet" | "truth" | "quiet" | "lit"} Kind */
/** @typedef {{ points: (Place | null)[], kind: Kind, label?: string }} Line null breaks it */
/**
 * @typedef {{ points: Place[], lit?: boolean, label?: string, base?: number }} Fill a bump down to
 *   its base (0); colours come in turn, so its number in the list is its colour
 */
/** @typedef {{ at: Place, kind: Kind | "word", label?: string }} Dot a word has no dot */
/** @typedef {{ from: number, to: number, label?: string }} Band a stretch of the x axis */
/**
 * @typedef {{
 *   name: string, axis: "x" | "y", value: number, low: number, high: number, step: number,
 *   label: string, text: string,
 * }} Threshold a line that can be dragged; `text` is its value in words
 */
/**
 * @typedef {{
 *   title: string, x: Axis, y: Axis, lines?: Line[], fills?: Fill[], dots?: Dot[],
 *   bands?: Band[], thresholds?: Threshold[], handles?: Handle[], playhead?: number | null,
 * }} Scene steps of handles and thresholds are parts of a decade where an axis is logarithmic
 */
export class Plot {
  /**
   * @param {{
   *   onHandle?(i: number, place: Place, isDone: boolean): void,
   *   onThreshold?(name: string, value: number, isDone: boolean): void,
   * }} listeners they hear every move, and at its end once more
   */
  constructor({ onHandle, onThreshold } = {}) {
    this.onThreshold = onThreshold;
    this.size = [0, 0];
    /** @type {Scene | null} */
    this.scene = null;
    /** @type {ReturnType<typeof drawAxes> | null} */
    this.view = null;
    /** @type {{ name: string, value: number } | null} a threshold in the hand */
    this.held = null;
    /** @type {Record<string, any>} what was drawn last */
    this.drawn = {};
    this.title = make("title", { id: newId("title") });
    this.clip = make("rect");
    const clip = make("clipPath", { id: newId("clip") }, this.clip);
    const hidden = { "aria-hidden": "true" };
    const clipped = { "clip-path": `url(#${clip.id})`, ...hidden };
    this.bands = make("g", hidden);
    this.axes = make("g", hidden);
    this.fills = make("g", clipped);
    this.lines = make("g", clipped);
    this.marks = make("g", hidden);
    this.bet = new Handles({ onHandle });
    this.thresholds = make("g");
    this.head = make("path", { class: "dt-playhead", ...hidden });
    this.node = make(
      "svg",
      { class: "dt-paper dt-plot", role: "group", "aria-labelledby": this.title.id },
      this.title,
      make("defs", {}, clip),
      ...[this.axes, this.bands, this.fills, this.lines, this.marks, this.head],
      ...[this.bet.node, this.thresholds],
    );
    new ResizeObserver(() => {
      this.size = [this.node.clientWidth, this.node.clientHeight];
      this.redraw();
    }).observe(this.node);
  }

  draw(/** @type {Scene} */ scene) {
    this.scene = scene;
    this.redraw();
  }

  redraw() {
    if (!this.size[0] || !this.scene) return;
    const { title, x, y, lines = [], fills = [], dots = [], bands = [], handles = [] } = this.scene;
    const ends = lines.filter(({ label }) => label).map(({ label }) => label);
    this.title.textContent = title;
    const axes = JSON.stringify([this.size, x, y, ends]);
    this.layer("axes", [axes], () => {
      this.view = drawAxes(this.axes, this.size, x, y, ends);
      const [left, top, right, bottom] = this.view.area;
      const size = { width: right - left + 6, height: bottom - top + 6 };
      change(this.clip, { x: left - 3, y: top - 3, ...size });
    });
    const { view } = this;
    this.layer("bands", [view, ...bands], () => drawBands(this.bands, view, bands));
    this.layer("fills", [view, ...fills], () => drawFills(this.fills, view, fills));
    this.layer("lines", [view, ...lines], () => drawLines(this.lines, view, lines));
    const marks = [view, ...fills, ...lines, ...dots];
    this.layer("marks", marks, () => {
      const labels = [
        ...badgesOf(view, fills),
        ...labelsOf(view, lines),
        ...dotsOf(view, this.scene),
      ];
      this.marks.replaceChildren(...labels);
    });
    this.bet.draw(handles, view);
    this.drawThresholds();
    const at = this.scene.playhead ?? null;
    const [, top, , bottom] = view.area;
    this.head.setAttribute("d", at === null ? "" : `M${view.x.px(at).toFixed(2)} ${top}V${bottom}`);
  }

  /**
   * Draw a layer when one of its parts has changed.
   * @param {string} name
   * @param {any[]} parts
   * @param {() => void} draw
   */
  layer(name, parts, draw) {
    const before = this.drawn[name] ?? [];
    if (before.length === parts.length && parts.every((part, i) => same(part, before[i]))) return;
    this.drawn[name] = parts;
    draw();
  }

  drawThresholds() {
    const { thresholds: group, view } = this;
    const all = this.scene.thresholds ?? [];
    while (group.childElementCount > all.length) group.lastChild.remove();
    while (group.childElementCount < all.length) {
      group.append(this.threshold(group.childElementCount));
    }
    for (const [i, threshold] of all.entries()) {
      const value = this.held?.name === threshold.name ? this.held.value : threshold.value;
      const isLow = all.some(({ axis, value: other }) => axis === threshold.axis && other > value);
      placeThreshold(group.children[i], view, { ...threshold, value }, isLow);
    }
  }

  threshold(/** @type {number} */ i) {
    const node = drawThreshold();
    const now = () => this.scene.thresholds[i];
    const along = (/** @type {Place} */ [x, y]) => (now().axis === "x" ? x : y);
    let off = 0;
    onDrag(node, {
      press: (at) => {
        const { axis, name, value } = now();
        off = this.view[axis].px(value) - along(at);
        this.held = { name, value };
        node.focus(/** @type {any} */ ({ preventScroll: true, focusVisible: false }));
        return true;
      },
      move: (places) => {
        this.moveThreshold(now(), this.view[now().axis].value(along(places.at(-1)) + off), false);
      },
      drop: () => this.moveThreshold(now(), this.held.value, true),
    });
    const keydown = (/** @type {KeyboardEvent} */ event) => {
      const { value, step, low, high, axis } = now();
      const way = WAYS[event.key];
      const edge = { Home: low, End: high }[event.key];
      if (!way && edge === undefined) return;
      event.preventDefault();
      event.stopPropagation();
      const by = way ? (way[0] + way[1]) * step * (event.shiftKey ? 10 : 1) : 0;
      this.moveThreshold(now(), edge ?? this.view[axis].moved(value, by), true);
    };
    return change(node, { keydown });
  }

  /**
   * Put a threshold where it is wanted, to a whole step within its limits.
   * @param {Threshold} threshold
   * @param {number} wanted
   * @param {boolean} isDone
   */
  moveThreshold({ name, low, high, axis, step }, wanted, isDone) {
    const whole = this.scene[axis].log ? wanted : Math.round(wanted / step) * step;
    const value = Number(within(whole, low, high).toPrecision(6));
    this.held = isDone ? null : { name, value };
    const thresholds = this.scene.thresholds.map((each) =>
      each.name === name ? { ...each, value } : each,
    );
    this.scene = { ...this.scene, thresholds };
    this.drawThresholds();
    this.onThreshold?.(name, value, isDone);
  }
}

/**
 * Whether two parts of a scene are the same, their points by identity.
 * @param {any} a
 * @param {any} b
 */
function same(a, b) {
  if (a === b || !a || !b || typeof a !== "object") return a === b;
  const names = Object.keys(a);
  return names.length === Object.keys(b).length && names.every((name) => a[name] === b[name]);
}
