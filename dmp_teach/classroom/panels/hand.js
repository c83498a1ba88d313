// What a hand does, in numbers: which point it means, what it paints, and the way it draws.

import { within } from "./scales.js";

/** @typedef {import("./layout.js").Place} Place */

export const distance = (/** @type {Place} */ p, /** @type {Place} */ q) =>
  Math.hypot(p[0] - q[0], p[1] - q[1]);

/**
 * Which point is the nearest, on the page or along one axis.
 * @param {Place[]} points
 * @param {Place} at
 * @param {number} [axis]
 */
export function nearest(points, at, axis) {
  const far = points.map((point) =>
    axis === undefined ? distance(point, at) : Math.abs(point[axis] - at[axis]),
  );
  return far.indexOf(Math.min(...far));
}

/**
 * Which handles a hand paints that goes from here to there, and where: those it passes, and in the
 * end the one nearest to it.
 * @param {Place[]} pixels in the order of x
 * @param {Place} from
 * @param {Place} to
 * @returns {[number, Place][]}
 */
export function painted(pixels, from, to) {
  const [first, last] = [nearest(pixels, from, 0), nearest(pixels, to, 0)];
  const way = Math.sign(last - first);
  /** @type {[number, Place][]} */
  const found = [];
  for (let i = first; i !== last; i += way) {
    const [x] = pixels[i];
    const part = (x - from[0]) / (to[0] - from[0]);
    if (part > 0) found.push([i, [x, from[1] + part * (to[1] - from[1])]]);
  }
  return [...found, [last, [pixels[last][0], to[1]]]];
}

export const lengthOf = (/** @type {Place[]} */ points) =>
  points.reduce((sum, point, i) => sum + (i ? distance(points[i - 1], point) : 0), 0);

/**
 * So many points along a stroke, from its start to its end, at equal lengths of the way.
 * @param {Place[]} points
 * @param {number} count
 * @returns {Place[]}
 */
export function alongStroke(points, count) {
  const whole = lengthOf(points);
  /** @type {Place[]} */
  const found = [];
  let gone = 0;
  let i = 1;
  for (let n = 0; n < count; n += 1) {
    const goal = count > 1 ? (whole * n) / (count - 1) : 0;
    let piece = distance(points[i - 1], points[i] ?? points[i - 1]);
    while (i < points.length - 1 && gone + piece < goal) {
      gone += piece;
      i += 1;
      piece = distance(points[i - 1], points[i]);
    }
    const [[x0, y0], [x1, y1]] = [points[i - 1], points[i] ?? points[i - 1]];
    const part = piece ? within((goal - gone) / piece, 0, 1) : 0;
    found.push([x0 + part * (x1 - x0), y0 + part * (y1 - y0)]);
  }
  return found;
}
