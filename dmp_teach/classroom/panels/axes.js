// The axes of a plot: a quiet grid, ticks with words, and where values stand on the screen.

import { make } from "../../views/dom.js";
import { scaleOf, ticksOf, within } from "./scales.js";

/** @typedef {import("./layout.js").Place} Place */
/** @typedef {import("./scales.js").Axis} Axis */
/** @typedef {ReturnType<typeof viewBetween>} View */

const LINE = 16;

/**
 * How a plot shows values in an area, and values what pixels are.
 * @param {Axis} x
 * @param {Axis} y
 * @param {number[]} area left, top, right, bottom [px]
 */
export function viewBetween(x, y, [left, top, right, bottom]) {
  const [across, up] = [scaleOf(x, left, right), scaleOf(y, bottom, top)];
  return {
    x: across,
    y: up,
    area: [left, top, right, bottom],
    px: (/** @type {Place} */ [a, b]) => [across.px(a), up.px(b)],
    metres: (/** @type {Place} */ [a, b]) => [across.value(a), up.value(b)],
    nudge: (/** @type {Place} */ at, /** @type {Place} */ by) => [
      across.moved(at[0], by[0]),
      up.moved(at[1], by[1]),
    ],
  };
}

/**
 * Draw axes as wide as their words need, and leave room at the right for labels of lines, unless
 * these are too long for it.
 * @param {SVGGElement} group
 * @param {number[]} size [px]
 * @param {Axis} x
 * @param {Axis} y
 * @param {string[]} ends labels
 */
export function drawAxes(group, [w, h], x, y, ends) {
  group.replaceChildren();
  if (x.ticks?.length === 0 && y.ticks?.length === 0) return bareView([w, h], x, y);
  const rows = Math.max(1, ...(x.ticks ?? []).map(([, words]) => words.split("\n").length));
  const top = y.label ? 36 : 20;
  const bottom = h - (x.label ? 34 : 14) - LINE * rows;
  const heights = ticksOf(y, (bottom - top) / 32);
  const left =
    28 +
    widest(
      group,
      heights.map(([, words]) => tickLabel(words, 0, 0, "end")),
    );
  const room = widest(
    group,
    ends.map((words) => make("text", { class: "dt-end" }, words)),
  );
  const right = w - (room > 0 && room + 24 < 0.3 * w ? room + 24 : 20);
  const sides = y.isEqual ? equalized(x, y, right - left, bottom - top) : [x, y];
  const view = viewBetween(sides[0], sides[1], [left, top, right, bottom]);
  const places = ticksOf(x, (right - left) / 64);
  const across = places.map(([value]) => view.x.px(value).toFixed(1));
  const up = heights.map(([value]) => view.y.px(value).toFixed(1));
  const grid = [...across.map((at) => `M${at} ${top}V${bottom}`)];
  grid.push(...up.map((at) => `M${left} ${at}H${right}`));
  const zero = y.low < 0 && y.high > 0 ? `M${left} ${view.y.px(0).toFixed(1)}H${right}` : "";
  const rule = `M${left} ${bottom}H${right}${across.map((at) => `M${at} ${bottom}v5`).join("")}`;
  group.append(
    make("path", { class: "dt-grid", d: grid.join("") }),
    make("path", { class: "dt-zero", d: zero }),
    make("path", { class: "dt-rule", d: rule }),
    make("text", { class: "dt-axis", x: 16, y: 22 }, y.label),
    ...heights.map(([, words], i) => tickLabel(words, left - 10, Number(up[i]), "end")),
  );
  const name = make("text", { class: "dt-axis dt-middle", y: h - 11 }, x.label);
  group.append(name);
  const half = name.getBBox().width / 2 + 4;
  name.setAttribute("x", String(within((left + right) / 2, half, w - half)));
  labelAcross(
    group,
    places.map(([, words], i) => [Number(across[i]), words]),
    bottom,
    w,
  );
  return { w, h, ...view };
}

/**
 * A plot without ticks needs no room for them, and has no rules.
 * @param {number[]} size [px]
 * @param {Axis} x
 * @param {Axis} y
 */
function bareView([w, h], x, y) {
  const sides = y.isEqual ? equalized(x, y, w - 20, h - 20) : [x, y];
  return { w, h, ...viewBetween(sides[0], sides[1], [10, 10, w - 10, h - 10]) };
}

/**
 * Two axes of which one unit is as long across as up, the shorter one with more room around.
 * @param {Axis} x
 * @param {Axis} y
 * @param {number} width [px]
 * @param {number} height [px]
 */
export function equalized(x, y, width, height) {
  const [a, b] = [(x.high - x.low) / width, (y.high - y.low) / height];
  const wider = (/** @type {Axis} */ axis, /** @type {number} */ factor) => {
    const room = ((factor - 1) * (axis.high - axis.low)) / 2;
    return { ...axis, low: axis.low - room, high: axis.high + room };
  };
  return a > b ? [x, wider(y, a / b)] : [wider(x, b / a), y];
}

/**
 * Words under the ticks: only the first line, or none, where they would touch the ones before.
 * @param {SVGGElement} group
 * @param {[number, string][]} places
 * @param {number} bottom
 * @param {number} w
 */
function labelAcross(group, places, bottom, w) {
  let edge = 0;
  for (const [x, words] of places) {
    for (const some of new Set([words, words.split("\n")[0]])) {
      const node = tickLabel(some, x, 0, "middle");
      group.append(node);
      const { width, height } = node.getBBox();
      const middle = within(x, width / 2 + 4, w - width / 2 - 4);
      node.setAttribute("transform", `translate(${middle} ${bottom + 8 + height / 2})`);
      if (middle - width / 2 >= edge) {
        edge = middle + width / 2 + 10;
        break;
      }
      node.remove();
    }
  }
}

/**
 * The words of a tick around its place, line by line.
 * @param {string} words
 * @param {number} x
 * @param {number} y
 * @param {"middle" | "end"} anchor
 */
function tickLabel(words, x, y, anchor) {
  const lines = words.split("\n");
  const texts = lines.map((line, n) => {
    const kind = lines.length > 1 && n === 0 ? "dt-tick dt-strong" : "dt-tick";
    const height = LINE * (n - (lines.length - 1) / 2) + 4.5;
    return make("text", { class: kind, y: height, "text-anchor": anchor }, line);
  });
  return make("g", { transform: `translate(${x} ${y})` }, ...texts);
}

/**
 * How wide the widest of some words is [px], once they stand in the picture.
 * @param {SVGGElement} group
 * @param {SVGGraphicsElement[]} nodes
 */
function widest(group, nodes) {
  group.append(...nodes);
  const wide = Math.max(0, ...nodes.map((node) => node.getBBox().width));
  for (const node of nodes) node.remove();
  return wide;
}
