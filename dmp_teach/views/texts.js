// What people read, in the language that Python speaks; English is the text in the code.

/** @typedef {string | [string[], number[]]} Translation with its forms, and which a number takes */

/** @type {Record<string, Translation>} */
let table = {};

/** Speak the language of a table from Python; an empty one is English. */
export function useTexts(/** @type {Record<string, Translation>} */ texts) {
  table = texts ?? {};
}

/**
 * A text in the language that is spoken, with values in the places of its {names}.
 * @param {string} text
 * @param {Record<string, string | number>} values
 */
export function t(text, values = {}) {
  return fill(/** @type {string} */ (table[text] ?? text), values);
}

/**
 * The text for n things, of which English has two; {n} is among the values.
 * @param {string} one
 * @param {string} many
 * @param {number} n
 * @param {Record<string, string | number>} values
 */
export function tn(one, many, n, values = {}) {
  const known = /** @type {[string[], number[]]} */ (table[one]);
  if (!known) return fill(n === 1 ? one : many, { n, ...values });
  const [forms, which] = known;
  return fill(forms[which[n < 100 ? n : 100 + (n % 100)]], { n, ...values });
}

function fill(/** @type {string} */ text, /** @type {Record<string, string | number>} */ values) {
  return text.replace(/\{(\w+)\}/g, (_, name) => String(values[name]));
}
