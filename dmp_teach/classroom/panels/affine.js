// Paths that are sums: drawn in the browser while a kernel computes, plans, or is gone.

/** @typedef {import("./layout.js").Place} Place */

/**
 * Bytes of float64 as Python sends them; they need not begin at a multiple of 8.
 * @param {DataView} bytes
 */
export function unpack({ buffer, byteOffset, byteLength }) {
  return new Float64Array(buffer.slice(byteOffset, byteOffset + byteLength));
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
