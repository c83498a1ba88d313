// Paths that are sums: drawn in the browser while a kernel computes, plans, or is gone.

/** @typedef {import("./layout.js").Place} Place */

/** @typedef {Float32Array | Float64Array} Numbers */

/** @type {WeakMap<DataView, Numbers>} */
const known = new WeakMap();

/**
 * The numbers in bytes as Python sends them, read once; they may begin anywhere in a message.
 * @param {DataView} bytes
 * @param {typeof Float64Array | typeof Float32Array} kind
 */
export function unpack(bytes, kind = Float64Array) {
  const { buffer, byteOffset, byteLength } = bytes;
  if (!known.has(bytes)) {
    const own = /** @type {ArrayBuffer} */ (buffer.slice(byteOffset, byteOffset + byteLength));
    known.set(bytes, new kind(own));
  }
  return known.get(bytes);
}

/**
 * The points of base + the sum of values[name] * terms[name].
 * @param {ArrayLike<number>} base x, y, x, y ...
 * @param {Record<string, ArrayLike<number>>} terms each as long as the base
 * @param {Record<string, number>} values of terms; one that is missing is 0
 * @returns {Place[]}
 */
export function affinePoints(base, terms, values) {
  const sum = Array.from(base);
  for (const [name, term] of Object.entries(terms)) {
    const value = values[name];
    if (value) for (let i = 0; i < sum.length; i += 1) sum[i] += value * term[i];
  }
  return Array.from({ length: sum.length / 2 }, (_, i) => [sum[2 * i], sum[2 * i + 1]]);
}
