// What stands on a plot: bands, bumps, lines with their labels, dots, and lines to drag.

import { change, make } from "../../views/dom.js";
import { alongStroke } from "./hand.js";
import { labelPlace } from "./layout.js";
import { pathOf, spread, within } from "./scales.js";

/** @typedef {import("./axes.js").View} View */
/** @typedef {import("./layout.js").Place} Place */
/** @typedef {import("./plot.js").Scene} Scene */

const LINES = {
  robot: "dt-robot-line",
  truth: "dt-robot-line",
  child: "dt-child-dots",
  bet: "dt-bet-line",
  quiet: "dt-quiet-line",
  lit: "dt-lit-line",
};

/**
 * Stretches of the x axis, each with its words at the top where there is room.
 * @param {SVGGElement} group
 * @param {View} view
 * @param {Scene["bands"]} bands
 */
export function drawBands(group, view, bands) {
  const [left, top, right, bottom] = view.area;
  group.replaceChildren();
  let edge = left;
  for (const { from, to, label } of bands) {
    const [x0, x1] = [from, to].map((value) => within(view.x.px(value), left, right));
    const sides = `M${x0} ${top}V${bottom}M${x1} ${top}V${bottom}`;
    group.append(
      make("rect", { class: "dt-band", x: x0, y: top, width: x1 - x0, height: bottom - top }),
      make("path", { class: "dt-band-edge", d: sides }),
    );
    const words = make("text", { class: "dt-band-label dt-middle", y: top + 18 }, label ?? "");
    group.append(words);
    const half = words.getBBox().width / 2;
    const x = within((x0 + x1) / 2, left + half, right - half);
    if (x - half < edge) words.remove();
    else edge = x + half + 12;
    words.setAttribute("x", String(x));
  }
}

/**
 * Bumps as soft shapes down to their base; a lit one lies on top.
 * @param {SVGGElement} group
 * @param {View} view
 * @param {Scene["fills"]} fills
 */
export function drawFills(group, view, fills) {
  const shapes = fills.map(({ points, lit, base = 0 }, i) => {
    const [first, last] = [points[0], points.at(-1)];
    const d = pathOf([[first[0], base], ...points, [last[0], base]], view.px);
    return make("path", { class: `dt-bump dt-bump-${i % 3}${lit ? " dt-lit" : ""}`, d: `${d}Z` });
  });
  const isLit = (/** @type {number} */ i) => Number(fills[i].lit ?? false);
  group.replaceChildren(
    ...shapes.sort((a, b) => isLit(shapes.indexOf(a)) - isLit(shapes.indexOf(b))),
  );
}

/**
 * The number of a bump, in a circle on it.
 * @param {View} view
 * @param {Scene["fills"]} fills
 */
export function badgesOf(view, fills) {
  const named = fills.filter(({ label }) => label);
  return named.map(({ points, label, base = 0 }) => {
    const high = (/** @type {Place} */ place) => Math.abs(place[1] - base);
    const most = Math.max(...points.map(high));
    const top = points.filter((place) => high(place) > 0.99 * most);
    const [x, y] = view.px([(top[0][0] + top.at(-1)[0]) / 2, base + 0.42 * (top[0][1] - base)]);
    const text = make("text", { class: "dt-count dt-middle", dy: 5 }, label);
    const circle = make("circle", { class: "dt-badge", r: 13 });
    return make("g", { transform: `translate(${x} ${y})` }, circle, text);
  });
}

/**
 * @param {SVGGElement} group
 * @param {View} view
 * @param {Scene["lines"]} lines
 */
export function drawLines(group, view, lines) {
  while (group.childElementCount > lines.length) group.lastChild.remove();
  while (group.childElementCount < lines.length) group.append(make("path"));
  for (const [i, { points, kind }] of lines.entries()) {
    change(group.children[i], { class: LINES[kind], d: pathOf(points, view.px) });
  }
}

/**
 * Where words stay on a picture of a width [px]: shifted, and narrowed where they are longer.
 * @param {number} width
 * @param {{ x: number, y: number, "text-anchor": string }} place
 * @param {string} words
 */
function keptOnPicture(width, place, words) {
  const room = width - 8;
  const wide = Math.min(8.5 * words.length, room);
  const before = { start: 0, middle: wide / 2, end: wide }[place["text-anchor"]] ?? 0;
  const left = within(place.x - before, 4, 4 + room - wide);
  const narrowed = wide < room ? {} : { textLength: room, lengthAdjust: "spacingAndGlyphs" };
  return { ...place, x: left + before, ...narrowed };
}

/**
 * What lines are, where they end; above it where there is no room beside.
 * @param {View & { w: number }} view
 * @param {Scene["lines"]} lines
 */
export function labelsOf(view, lines) {
  const [, top, right, bottom] = view.area;
  const isInside = view.w - right <= 20;
  const named = lines
    .map(({ points, label, kind }) => ({ label, kind, end: points.findLast((at) => at) }))
    .filter(({ label, end }) => label && end);
  const ends = named.map(({ end }) => view.px(end));
  const wanted = ends.map(([, y]) => y - (isInside ? 12 : 0));
  const heights = spread(wanted, 18, top + 4, bottom - 4);
  return named.map(({ label, kind }, i) => {
    const x = Math.min(ends[i][0], right) + (isInside ? -2 : 10);
    const place = { x, y: heights[i] + 5, "text-anchor": isInside ? "end" : "start" };
    const look = { class: `dt-end dt-of-${kind}`, ...keptOnPicture(view.w, place, label) };
    return make("text", look, label);
  });
}

/**
 * Dots, each with its words where they hide the least of the lines.
 * @param {View & { w: number, h: number }} view
 * @param {Scene} scene
 */
export function dotsOf(view, { y, dots = [], lines = [], handles = [] }) {
  const named = dots.some(({ label }) => label);
  const drawn = [...lines.map(({ points }) => points), handles.map(({ at }) => at)]
    .map((points) => points.filter((at) => at).map(view.px))
    .filter((pixels) => named && pixels.length > 1)
    .map((pixels) => alongStroke(pixels, 200));
  drawn.push(
    alongStroke(
      [
        [16, 18],
        [16 + 8 * y.label.length, 18],
      ],
      200,
    ),
  );
  const screen = { ...view, k: 1, px: (/** @type {Place} */ at) => at };
  return dots.flatMap(({ at, kind, label }) => {
    const [cx, cy] = view.px(at);
    const dot = make("circle", { class: `dt-dot dt-of-${kind}`, cx, cy, r: 7 });
    if (!label) return [dot];
    const place =
      kind === "word"
        ? { x: cx, y: cy + 5, "text-anchor": "middle" }
        : labelPlace(screen, [cx, cy], drawn, 8.5 * label.length);
    const look = { class: `dt-end dt-of-${kind}`, ...keptOnPicture(view.w, place, label) };
    return [dot, make("text", look, label)];
  });
}

/** A line to drag, with a grip at its end. */
export function drawThreshold() {
  return make(
    "g",
    { class: "dt-threshold", role: "slider", tabindex: 0 },
    make("path", { class: "dt-catch" }),
    make("path", { class: "dt-edge-line" }),
    make("text", { class: "dt-name" }),
    make("text", { class: "dt-value" }),
    make(
      "g",
      {},
      make("rect", { class: "dt-focus", x: -20, y: -15, width: 40, height: 30, rx: 15 }),
      make("rect", { class: "dt-grip", x: -15, y: -10, width: 30, height: 20, rx: 10 }),
      make("path", { class: "dt-ways", d: "M-5 -2l5 -4l5 4M-5 2l5 4l5 -4" }),
    ),
  );
}

/**
 * Lay a line to drag across the plot, its words above it or, of a lower one, below.
 * @param {Element} node
 * @param {View} view
 * @param {Scene["thresholds"][0]} threshold
 * @param {boolean} isLow
 */
export function placeThreshold(node, view, threshold, isLow) {
  const { axis, value, low, high, label, text } = threshold;
  const [left, top, right, bottom] = view.area;
  const at = within(view[axis].px(value), axis === "x" ? left : top, axis === "x" ? right : bottom);
  const isUpright = axis === "x";
  const d = isUpright ? `M${at} ${top}V${bottom}` : `M${left} ${at}H${right}`;
  const isBelow = at < top + 22 || (isLow && at < bottom - 22);
  const isRight = isLow ? at < left + 120 : at < right - 120;
  const beside = { x: at + (isRight ? 16 : -16), "text-anchor": isRight ? "start" : "end" };
  const height = at + (isBelow ? 20 : -9);
  const [name, words] = isUpright
    ? [
        { ...beside, y: top - 6 },
        { ...beside, y: top + 12 },
      ]
    : [
        { x: left + 8, y: height },
        { x: right - 24, y: height, "text-anchor": "end" },
      ];
  change(node, {
    class: `dt-threshold dt-along-${axis}`,
    "aria-label": label,
    "aria-orientation": isUpright ? "horizontal" : "vertical",
    "aria-valuemin": low,
    "aria-valuemax": high,
    "aria-valuenow": value,
    "aria-valuetext": text,
  });
  const [reach, line, title, says, grip] = node.children;
  for (const path of [reach, line]) path.setAttribute("d", d);
  change(title, name).replaceChildren(label);
  change(says, words).replaceChildren(text);
  const turned = isUpright ? `translate(${at} ${top + 9}) rotate(90)` : `translate(${right} ${at})`;
  grip.setAttribute("transform", turned);
}
