// Where things stand on a sheet: numbers in, numbers out, without a page.

import { t } from "../../views/texts.js";

/** @typedef {number[]} Place x and y */
/**
 * @typedef {{
 *   w: number, h: number, k: number, px(place: Place): Place, metres(pixel: Place): Place,
 * }} View how a sheet of w by h pixels shows metres; k is pixels a metre
 */
/** @typedef {"start" | "middle" | "end"} Anchor */

const AROUND = Array.from({ length: 16 }, (_, i) => [
  Math.cos((Math.PI * i) / 8),
  Math.sin((Math.PI * i) / 8),
]);

/**
 * How a sheet of a size [px] shows a box of metres, in its middle and as large as it can be; of a
 * box that is turned the corners may be cut off.
 * @param {number[]} box left, bottom, right, top [m]
 * @param {number[]} size [px]
 * @param {number} turn with the clock [rad]
 * @returns {View}
 */
export function viewOf([x0, y0, x1, y1], [w, h], turn = 0) {
  const [cos, sin] = [Math.cos(turn), Math.sin(turn)];
  const [wide, high] = [x1 - x0, y1 - y0];
  const k = Math.min(
    w / Math.hypot(wide * cos, high * sin),
    h / Math.hypot(wide * sin, high * cos),
  );
  const middle = [(x0 + x1) / 2, (y0 + y1) / 2];
  return {
    w,
    h,
    k,
    px: ([x, y]) => {
      const [right, down] = [(x - middle[0]) * k, (middle[1] - y) * k];
      return [w / 2 + right * cos - down * sin, h / 2 + right * sin + down * cos];
    },
    metres: ([x, y]) => {
      const [right, down] = [(x - w / 2) / k, (y - h / 2) / k];
      return [middle[0] + right * cos + down * sin, middle[1] + right * sin - down * cos];
    },
  };
}

/** How many centimetres the bar has that shows them. */
export function rulerLength(/** @type {View} */ { k }) {
  return [1, 2, 5, 10, 20].find((n) => n * 0.01 * k > 48) ?? 50;
}

/** Where its words end. */
const rulerEnd = (/** @type {View} */ view) => 16 + Math.max(rulerLength(view) * 0.01 * view.k, 52);

/**
 * One label for starts that lie on each other: "start 1, 2".
 * @param {View} view
 * @param {Place[][]} strokes
 * @param {(number: number) => string} name
 */
export function startLabels(view, strokes, name) {
  /** @type {{ at: Place, words: string }[]} */
  const labels = [];
  for (const [i, points] of strokes.entries()) {
    const at = view.px(points[0]);
    const near = labels.find((label) => distance(label.at, at) < 24);
    if (near) near.words += `, ${i + 1}`;
    else labels.push({ at, words: name(i + 1) });
  }
  return labels;
}

// [px] Room for one letter of a label.
export const LETTER = 9;

/**
 * Where a label hides the least ink: right, left, above or below its point.
 * @param {View} view
 * @param {Place} at
 * @param {Place[][]} strokes
 * @param {number} wide [px]
 */
export function labelPlace(view, [x, y], strokes, wide) {
  const ink = everyNth(strokes.flat(), 4).map(view.px);
  /** @type {[number, number, Anchor][]} */
  const places = [
    [14, 5, "start"],
    [-14, 5, "end"],
    [0, -14, "middle"],
    [12, -10, "start"],
    [-12, -10, "end"],
    [0, 26, "middle"],
  ];
  const best = least(places, ([dx, dy, anchor]) => {
    const left = x + dx - { start: 0, middle: wide / 2, end: wide }[anchor];
    const right = left + wide + 4;
    const hidden = ink.filter(
      ([px, py]) => px > left - 4 && px < right && Math.abs(py - y - dy + 5) < 11,
    );
    const isOff = left < 4 || right > view.w || y + dy < 16 || y + dy > view.h - 6;
    return hidden.length + (isOff ? 100 : 0);
  });
  return { x: x + best[0], y: y + best[1], "text-anchor": best[2] };
}

/**
 * Where the word "goal" hides the least ink: above, below, right or left of its ring.
 * @param {View} view
 * @param {Place} goal
 * @param {Place[][]} strokes
 * @param {number} wide of the word [px]
 */
export function wordPlace(view, goal, strokes, wide = 36) {
  const [x, y] = view.px(goal);
  const ink = everyNth(strokes.flat(), 3).map(view.px);
  /** @type {[number, number, Anchor, number][]} */
  const places = [
    [0, -24, "middle", -wide / 2],
    [0, 36, "middle", -wide / 2],
    [24, 5, "start", 0],
    [-24, 5, "end", -wide],
  ];
  const [dx, dy, anchor] = least(places, ([right, down, , left]) => {
    const [x0, y0] = [x + right + left, y + down - 5];
    const hidden = ink.filter(
      ([px, py]) => px > x0 - 4 && px < x0 + wide + 4 && Math.abs(py - y0) < 12,
    );
    const isOff = x0 < 4 || x0 + wide > view.w - 4 || y0 < 12 || y0 > view.h - 12;
    return hidden.length + (isOff ? 100 : 0);
  });
  return { x: dx, y: dy, "text-anchor": anchor };
}

/**
 * A place for each stroke's number, away from the other rings and numbers, so that each can be
 * caught; where there is only one, it needs none.
 * @param {View} view
 * @param {Place[]} goals
 * @param {Place[][]} strokes
 * @returns {(Place | null)[]} [px] from the ring
 */
export function badgePlaces(view, goals, strokes) {
  if (goals.length < 2) return [null];
  const places = goals.map(view.px);
  const ink = everyNth(strokes.flat(), 6).map(view.px);
  /** @type {Place[]} */
  const taken = [];
  for (const [i, [x, y]] of places.entries()) {
    const others = places.filter((_, j) => j !== i);
    const cost = (/** @type {Place} */ [dx, dy]) => {
      const at = [x + 40 * dx, y + 40 * dy];
      const crowd = 8 * near(at, taken, 46) + 4 * near(at, others, 30) + near(at, ink, 22);
      const off = Math.max(0, 24 - at[0], 24 - at[1], at[0] - view.w + 24, at[1] - view.h + 24);
      const ruler = Math.max(0, Math.min(rulerEnd(view) + 20 - at[0], at[1] - view.h + 68));
      return 30 * (off + ruler) + crowd;
    };
    const best = least(AROUND, cost, 1e-9);
    taken.push([x + 40 * best[0], y + 40 * best[1]]);
  }
  return taken.map(([x, y], i) => [x - places[i][0], y - places[i][1]]);
}

/**
 * The side where the line is furthest off the sheet, and by how much: "0.4 m further right".
 * @param {View} view
 * @param {Place[]} points
 */
export function outside(view, points) {
  const { w, h, k } = view;
  const sides = points.map(view.px).flatMap(([x, y]) => [
    {
      far: x - w,
      way: "right",
      at: [w - 30, y],
      arrow: [-8, -8, 8, 0, -8, 8],
    },
    {
      far: -x,
      way: "left",
      at: [30, y],
      arrow: [8, -8, -8, 0, 8, 8],
    },
    {
      far: -y,
      way: "up",
      at: [x, 30],
      arrow: [-8, 8, 0, -8, 8, 8],
    },
    {
      far: y - h,
      way: "down",
      at: [x, h - 30],
      arrow: [-8, -8, 0, 8, 8, -8],
    },
  ]);
  if (!sides.length) return null;
  const { far, way, at, arrow } = sides.reduce((a, b) => (b.far > a.far ? b : a));
  if (far <= 4) return null;
  const x = Math.min(Math.max(at[0], 30), w - 30);
  // The ruler stands at the left, below.
  const y = Math.min(Math.max(at[1], 30), h - (x < rulerEnd(view) ? 84 : 44));
  const metres = far / k;
  const size =
    metres < 0.1
      ? t("{n} cm", { n: Math.ceil(100 * metres) })
      : t("{n} m", { n: metres.toFixed(1) });
  /** @type {Record<string, string>} */
  const words = {
    right: t("{size} further right", { size }),
    left: t("{size} further left", { size }),
    up: t("{size} further up", { size }),
    down: t("{size} further down", { size }),
  };
  const [x0, y0, x1, y1, x2, y2] = arrow.map((value, i) => value + (i % 2 ? y : x));
  const anchor = x > w / 2 ? "end" : "start";
  return {
    arrow: `M${x0} ${y0}L${x1} ${y1}L${x2} ${y2}`,
    at: { x: anchor === "end" ? x + 12 : x - 12, y: y + 28, "text-anchor": anchor },
    words: words[way],
  };
}

const distance = (/** @type {Place} */ p, /** @type {Place} */ q) =>
  Math.hypot(p[0] - q[0], p[1] - q[1]);

const everyNth = (/** @type {Place[]} */ points, /** @type {number} */ n) =>
  points.filter((_, i) => i % n === 0);

/**
 * How much nearer than a reach some points are, added up.
 * @param {Place} at
 * @param {Place[]} points
 * @param {number} reach
 */
function near(at, points, reach) {
  return points.reduce((sum, point) => sum + Math.max(0, reach - distance(point, at)), 0);
}

/**
 * The first of the choices whose cost is the least, by more than `margin`.
 * @template T
 * @param {T[]} choices
 * @param {(choice: T) => number} cost
 */
function least(choices, cost, margin = 0) {
  return choices.reduce((a, b) => (cost(b) < cost(a) - margin ? b : a));
}
