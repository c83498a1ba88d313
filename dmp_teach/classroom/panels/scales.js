// Axes in numbers: scales, ticks, paths, and room between labels.

/** @typedef {import("./layout.js").Place} Place */
/**
 * @typedef {{
 *   label: string, low: number, high: number, log?: boolean, ticks?: [number, string][],
 *   isEqual?: boolean,
 * }} Axis in words of a tick, what follows a line break is written smaller below; y may ask that
 *   its unit be as long as that of x
 */

// Nothing is drawn further off than this [px].
const FAR = 1e4;

export const within = (/** @type {number} */ value, /** @type {number} */ low, high = Infinity) =>
  Math.min(Math.max(value, low), high);

const rounded = (/** @type {number} */ value) => Number(value.toPrecision(12)) + 0;

/**
 * How an axis shows values from one pixel to another. A step is added; on a logarithmic axis it is
 * a part of a decade.
 * @param {Axis} axis
 * @param {number} from [px]
 * @param {number} to [px]
 */
export function scaleOf({ low, high, log }, from, to) {
  const into = (/** @type {number} */ value) =>
    log ? Math.log10(Math.max(value, Number.MIN_VALUE)) : value;
  const back = (/** @type {number} */ place) => (log ? 10 ** place : place);
  const first = into(low);
  const k = (to - from) / (into(high) - first || 1);
  return {
    px: (/** @type {number} */ value) => within(from + (into(value) - first) * k, -FAR, FAR),
    value: (/** @type {number} */ pixel) => rounded(back(first + (pixel - from) / k)),
    moved: (/** @type {number} */ value, /** @type {number} */ step) =>
      rounded(back(into(value) + step)),
  };
}

/**
 * The ticks of an axis, with their words: those that were given, or about as many round numbers as
 * there is room for.
 * @param {Axis} axis
 * @param {number} most
 * @returns {[number, string][]}
 */
export function ticksOf({ low, high, log, ticks }, most) {
  if (ticks) return ticks.filter(([value]) => value >= low && value <= high);
  const values = (log ? logTicks : niceTicks)(low, high, most);
  return values.map((value) => [value, String(value).replace("-", "−")]);
}

/**
 * Multiples of 1, 2 or 5 times a power of ten.
 * @param {number} low
 * @param {number} high
 * @param {number} most
 */
export function niceTicks(low, high, most) {
  const rough = (high - low) / Math.max(most, 1);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * [1, 2, 5, 10].find((n) => n * power >= rough * (1 - 1e-9));
  const first = Math.ceil(low / step - 1e-9);
  const count = Math.floor(high / step + 1e-9) - first + 1;
  return Array.from({ length: count }, (_, i) => rounded((first + i) * step));
}

/**
 * 1, 2, 5 of every decade; decades alone, or every second, third ... where those are too many.
 * @param {number} low
 * @param {number} high
 * @param {number} most
 */
export function logTicks(low, high, most) {
  const first = Math.floor(Math.log10(low));
  const decades = Array.from({ length: Math.ceil(Math.log10(high)) - first + 1 }, (_, i) => i);
  const ticks = (/** @type {number[]} */ heads, every = 1) =>
    decades
      .filter((i) => (first + i) % every === 0)
      .flatMap((i) => heads.map((head) => rounded(head * 10 ** (first + i))))
      .filter((value) => value >= low && value <= high);
  const all = ticks([1, 2, 5]);
  if (all.length < 3) return niceTicks(low, high, most);
  const fewer = [all, ...decades.map((i) => ticks([1], i + 1))];
  return fewer.find((values) => values.length <= Math.max(most, 2)) ?? ticks([1], decades.length);
}

/**
 * Places of labels that keep a gap and stay near to where they are wanted.
 * @param {number[]} wanted
 * @param {number} gap
 * @param {number} low
 * @param {number} high
 */
export function spread(wanted, gap, low, high) {
  const order = wanted.map((_, i) => i).sort((a, b) => wanted[a] - wanted[b]);
  const places = [...wanted];
  let edge = low;
  for (const i of order) {
    places[i] = Math.max(places[i], edge);
    edge = places[i] + gap;
  }
  edge = high;
  for (const i of order.reverse()) {
    places[i] = Math.min(places[i], edge);
    edge = places[i] - gap;
  }
  return places;
}

/**
 * A path through points; null, or what is no number, breaks it.
 * @param {(Place | null)[]} points
 * @param {(place: Place) => Place} px
 */
export function pathOf(points, px) {
  let d = "";
  let pen = "M";
  for (const point of points) {
    const [x, y] = point ? px(point) : [Number.NaN, 0];
    const isThere = Number.isFinite(x + y);
    if (isThere) d += `${pen}${x.toFixed(2)} ${y.toFixed(2)}`;
    pen = isThere ? "L" : "M";
  }
  return d;
}
