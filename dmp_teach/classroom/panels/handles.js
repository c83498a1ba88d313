// A bet that is made by hand: round handles on a dashed line, over a plot or a sheet.

import { change, make } from "../../views/dom.js";
import { t } from "../../views/texts.js";
import { alongStroke, distance, lengthOf, nearest, painted } from "./hand.js";
import { pathOf, within } from "./scales.js";

/** @typedef {import("./layout.js").Place} Place */
/**
 * @typedef {{
 *   w: number, h: number, px(place: Place): Place, metres(pixel: Place): Place,
 *   area?: number[], nudge?(place: Place, by: Place): Place,
 * }} Ground where handles stand: a view, with the left, top, right and bottom [px] of what they may
 *   reach, and how a place is moved by steps
 */
/**
 * @typedef {{
 *   at: Place, first: Place, label: string, text: string, axis: "y" | "xy", step: number,
 * }} Handle `text` is what is shown and read, `first` where it was before anyone moved it
 */

const CATCH = 22;
// A stroke that is shorter [px] is a slip of the hand.
const SLIP = 24;
// A line that begins far from its first handle has at least this part of the way to its last one.
const LEAST_PART = 0.8;
/** @type {Record<string, Place>} */
export const WAYS = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

export class Handles {
  /**
   * @param {{
   *   onHandle?(i: number, place: Place, isDone: boolean): void, onShort?(): void,
   * }} listeners it hears each handle that moves, what is drawn meanwhile leaves the places to the
   *   hand; and of a line that was too short, and is taken back
   */
  constructor({ onHandle, onShort }) {
    this.onHandle = onHandle;
    this.onShort = onShort;
    /** @type {Handle[]} */
    this.handles = [];
    /** @type {Ground | null} */
    this.view = null;
    /**
     * @type {{
     *   i: number, off: Place, from: Place, stroke?: Place[], before: Place[], moved?: boolean,
     * } | null}
     */
    this.held = null;
    this.current = 0;
    this.ground = make("rect", { class: "dt-ground" });
    this.line = make("path", { class: "dt-bet-line" });
    this.knobs = make("g");
    this.node = make("g", {}, this.ground, this.line, this.knobs);
    onDrag(this.node, {
      press: (at) => this.press(at),
      move: (places) => this.move(places),
      drop: () => this.drop(),
    });
    change(this.node, { keydown: (/** @type {KeyboardEvent} */ event) => this.key(event) });
  }

  draw(/** @type {Handle[]} */ handles, /** @type {Ground} */ view) {
    if (handles.length !== this.handles.length) {
      this.held = null;
      this.current = 0;
    }
    const places = this.handles.map(({ at }) => at);
    this.handles = handles.map((each, i) => ({ ...each, at: this.held ? places[i] : each.at }));
    this.view = view;
    this.redraw();
  }

  redraw() {
    const { handles, view, knobs } = this;
    const [left, top, right, bottom] = areaOf(view);
    const size = handles.length ? { width: right - left, height: bottom - top } : { width: 0 };
    change(this.ground, { x: left, y: top, ...size });
    const places = handles.map(({ at }) => at);
    this.line.setAttribute("d", pathOf(places, view.px));
    while (knobs.childElementCount > handles.length) knobs.lastChild.remove();
    while (knobs.childElementCount < handles.length) knobs.append(this.knob());
    for (const [i, { at, label, text, axis }] of handles.entries()) {
      const [x, y] = view.px(at);
      const knob = knobs.children[i];
      const isFresh = this.isFresh(handles[i]);
      // More numbers than two would lie over each other.
      const isTold = !isFresh && axis === "y" && handles.length <= 2;
      const [low, high] = [view.metres([x, bottom])[1], view.metres([x, top])[1]];
      change(knob, {
        class: `dt-handle dt-along-${axis}${isFresh ? " dt-fresh" : ""}${isTold ? " dt-told" : ""}`,
        transform: `translate(${x.toFixed(2)} ${y.toFixed(2)})`,
        tabindex: axis === "xy" || i === this.current ? 0 : -1,
        "aria-label": label,
        "aria-orientation": axis === "y" ? "vertical" : null,
        "aria-valuemin": Number(low.toPrecision(6)),
        "aria-valuemax": Number(high.toPrecision(6)),
        "aria-valuenow": Number(at[1].toPrecision(6)),
        "aria-valuetext": isFresh ? t("{text}, not moved yet", { text }) : text,
      });
      const side = x > right - 40 ? "end" : "middle";
      const said = { y: y - top < 50 ? 34 : -20, "text-anchor": x < left + 40 ? "start" : side };
      change(knob.lastElementChild, said).replaceChildren(text);
    }
  }

  knob() {
    const focus = (/** @type {FocusEvent} */ event) => {
      this.current = [...this.knobs.children].indexOf(/** @type {Element} */ (event.currentTarget));
      this.redraw();
    };
    return make(
      "g",
      { role: "slider", focus },
      make("circle", { class: "dt-catch", r: CATCH }),
      make("circle", { class: "dt-focus", r: 15 }),
      make("path", { class: "dt-ways", d: "M-5 -14l5 -5l5 5M-5 14l5 5l5 -5" }),
      make("circle", { class: "dt-knob", r: 8 }),
      make("text"),
    );
  }

  /** Whether nobody has moved a handle, also before the page was loaded anew. */
  isFresh(/** @type {Handle} */ { at, first }) {
    return distance(this.view.px(at), this.view.px(first)) < 0.5;
  }

  /** Where the handles are [px]. */
  pixels() {
    return this.handles.map(({ at }) => this.view.px(at));
  }

  press(/** @type {Place} */ at) {
    if (!this.handles.length) return false;
    const pixels = this.pixels();
    const near = nearest(pixels, at);
    const isRow = this.handles[0].axis === "y";
    // A line is drawn from its start, which is where the first handle is; two are its ends.
    const isLine = !isRow && pixels.length > 2;
    const draws = isLine && (near === 0 || this.handles.every((each) => this.isFresh(each)));
    const isOn = !draws && distance(pixels[near], at) <= CATCH;
    const i = isRow && !isOn ? nearest(pixels, at, 0) : near;
    const off = isOn ? [pixels[i][0] - at[0], pixels[i][1] - at[1]] : [0, 0];
    const from = [at[0] + off[0], at[1] + off[1]];
    const before = this.handles.map((each) => each.at);
    this.held = { i, off, from, stroke: isOn || isRow ? undefined : [at], before };
    if (!this.held.stroke) this.focus(i);
    if (isRow && !isOn) this.move([at]);
    return true;
  }

  move(/** @type {Place[]} */ places) {
    const { held } = this;
    if (!held) return;
    /** @type {Map<number, Place>} */
    const moved = new Map();
    const put = (/** @type {number} */ i, /** @type {Place} */ pixel) =>
      moved.set(i, this.view.metres(pixel));
    const pixels = this.pixels();
    if (held.stroke) {
      held.stroke.push(...places);
      if (lengthOf(held.stroke) < SLIP) return;
      for (const [i, at] of alongStroke(held.stroke, pixels.length).entries()) put(i, at);
    }
    for (const [x, y] of held.stroke ? [] : places) {
      const to = [x + held.off[0], y + held.off[1]];
      if (this.handles[0].axis === "xy") put(held.i, to);
      else for (const [i, at] of painted(pixels, held.from, to)) put(i, at);
      held.from = to;
    }
    const last = [...moved.keys()].at(-1);
    if (!held.stroke && last !== held.i) this.focus(last);
    held.i = last;
    this.put(moved, false);
  }

  drop() {
    const { held } = this;
    const isShort = held?.moved && held.stroke && this.isShort(held.stroke, held.before);
    if (isShort) this.put(new Map(held.before.entries()), false);
    this.held = null;
    if (isShort) this.onShort?.();
    else if (held?.moved) this.onHandle?.(held.i, this.handles[held.i].at, true);
  }

  /**
   * Whether a stroke is a dash in the middle rather than the line that is asked for.
   * @param {Place[]} stroke
   * @param {Place[]} before where the handles were
   */
  isShort(stroke, before) {
    const pixels = before.map((at) => this.view.px(at));
    const isNear = distance(stroke[0], pixels[0]) <= 2 * CATCH;
    const way = distance(pixels[0], pixels.at(-1));
    return pixels.length > 2 && !isNear && lengthOf(stroke) < LEAST_PART * way;
  }

  /**
   * Move handles to places, as far as they may.
   * @param {Map<number, Place>} moved
   * @param {boolean} isDone
   */
  put(moved, isDone) {
    const [left, top, right, bottom] = areaOf(this.view);
    for (const [i, place] of moved) {
      const each = this.handles[i];
      const [x, y] = this.view.px(place);
      const inside = [within(x, left, right), within(y, top, bottom)];
      const isIn = inside[0] === x && inside[1] === y;
      const at = isIn ? place : this.view.metres(inside);
      each.at = each.axis === "y" ? [each.at[0], at[1]] : at;
    }
    if (this.held) this.held.moved = true;
    this.redraw();
    for (const i of moved.keys()) this.onHandle?.(i, this.handles[i].at, isDone);
  }

  key(/** @type {KeyboardEvent} */ event) {
    const i = [...this.knobs.children].indexOf(/** @type {Element} */ (event.target));
    const way = WAYS[event.key];
    if (i < 0 || (!way && event.key !== "Home" && event.key !== "End")) return;
    event.preventDefault();
    event.stopPropagation();
    const { at, axis, step } = this.handles[i];
    if (axis === "y" && way?.[0]) {
      this.focus(within(i + way[0], 0, this.handles.length - 1));
      return;
    }
    const [, top, , bottom] = areaOf(this.view);
    const [x] = this.view.px(at);
    const by = (way ?? [0, 0]).map((value) => value * step * (event.shiftKey ? 10 : 1));
    const next = this.view.nudge?.(at, by) ?? [at[0] + by[0], at[1] + by[1]];
    const edge = this.view.metres([x, event.key === "Home" ? bottom : top]);
    this.put(new Map([[i, way ? next : edge]]), true);
  }

  focus(/** @type {number} */ i) {
    const knob = /** @type {SVGElement} */ (this.knobs.children[i]);
    knob.focus(/** @type {any} */ ({ preventScroll: true, focusVisible: !this.held }));
  }
}

const areaOf = (/** @type {Ground} */ { area, w, h }) => area ?? [0, 0, w, h];

/**
 * Hear a pointer from press to release, in pixels of the picture.
 * @param {SVGGElement} node
 * @param {{ press(at: Place): boolean, move(places: Place[]): void, drop(): void }} hand `press`
 *   says whether it takes hold
 */
export function onDrag(node, { press, move, drop }) {
  /** @type {number | null} */
  let id = null;
  /** @type {DOMMatrix} of the press: where the page moves meanwhile, the hand has not moved */
  let ground;
  const place = (/** @type {PointerEvent} */ { clientX, clientY }) => {
    const { a, d, e, f } = ground;
    return [(clientX - e) / a, (clientY - f) / d];
  };
  const end = (/** @type {PointerEvent} */ event) => {
    if (event.pointerId !== id) return;
    id = null;
    drop();
  };
  const pointerdown = (/** @type {PointerEvent} */ event) => {
    if (event.button || id !== null) return;
    ground = node.ownerSVGElement.getScreenCTM();
    if (!press(place(event))) return;
    id = event.pointerId;
    node.setPointerCapture(id);
    event.preventDefault();
  };
  const pointermove = (/** @type {PointerEvent} */ event) => {
    if (event.pointerId !== id) return;
    const all = event.getCoalescedEvents?.() ?? [];
    move((all.length ? all : [event]).map(place));
  };
  change(node, { pointerdown, pointermove, pointerup: end, pointercancel: end });
  // Chromium heeds no `touch-action` inside an SVG: a finger would scroll the notebook.
  node.addEventListener("touchstart", (event) => event.preventDefault(), { passive: false });
}
