// What a lesson draws, made of the arrays that the kernel sends once: a knob that is drawn here
// needs no answer.

import { affinePoints, unpack } from "../panels/affine.js";

/** @typedef {Record<string, any>} Values what is set, by the names of the knobs */

/** @type {WeakMap<object, any>} what each part of a picture was resolved to last */
const LAST = new WeakMap();

/**
 * What came out last where all its parts are the same, so that nobody draws anew what stands still.
 * @param {object} drawing
 * @param {any} parts
 */
function same(drawing, parts) {
  const last = LAST.get(drawing);
  if (last && Object.keys(parts).every((name) => parts[name] === last[name])) return last;
  LAST.set(drawing, parts);
  return parts;
}

/**
 * Points [x, y]; one that is not a number breaks a line and comes as null.
 * @param {DataView} base
 * @param {Record<string, DataView>} terms
 * @param {Values} values
 */
function points(base, terms, values) {
  const each = Object.entries(terms).map(([name, term]) => [name, unpack(term)]);
  const places = affinePoints(unpack(base), Object.fromEntries(each), values);
  return places.map((place) => (place.every(Number.isFinite) ? place : null));
}

/**
 * A picture with the knobs as they are now.
 * @param {any} drawing
 * @param {Values} values
 * @param {Record<string, any>} knobs
 * @returns {any}
 */
export function resolve(drawing, values, knobs) {
  if (drawing instanceof DataView) {
    if (!LAST.has(drawing)) LAST.set(drawing, points(drawing, {}, values));
    return LAST.get(drawing);
  }
  if (Array.isArray(drawing)) {
    const each = drawing.map((part) => resolve(part, values, knobs));
    return same(drawing, each);
  }
  if (!drawing || typeof drawing !== "object") return drawing;
  if (drawing.base instanceof DataView) return points(drawing.base, drawing.terms, values);
  if (drawing.pick) return resolve(picked(drawing, values, knobs), values, knobs);
  const parts = Object.entries(drawing).map(([name, each]) => [name, resolve(each, values, knobs)]);
  return same(drawing, Object.fromEntries(parts));
}

/**
 * @param {{ pick: string, pictures: any[] }} drawing
 * @param {Values} values
 * @param {Record<string, any>} knobs
 */
function picked({ pick, pictures }, values, knobs) {
  const { kind, options, low } = knobs[pick];
  const place =
    kind === "choice"
      ? options.findIndex((/** @type {string[]} */ [value]) => value === values[pick])
      : Math.round(values[pick] - low);
  return pictures[Math.min(Math.max(place, 0), pictures.length - 1)];
}
