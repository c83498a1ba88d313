// What is said of the sliders and rings of the start panel.

import { t } from "../../views/texts.js";

// Below this [m] a goal has not been moved.
export const UNMOVED = 5e-5;

/** What the goal's sliders are called, and how far is read aloud: of x, of y. */
export const goalTexts = () => [
  {
    label: t("Goal, left and right"),
    term: "x",
    less: (/** @type {string} */ n) => t("{n} centimetres to the left", { n }),
    more: (/** @type {string} */ n) => t("{n} centimetres to the right", { n }),
  },
  {
    label: t("Goal, down and up"),
    term: "y",
    less: (/** @type {string} */ n) => t("{n} centimetres down", { n }),
    more: (/** @type {string} */ n) => t("{n} centimetres up", { n }),
  },
];

export const widthText = (/** @type {number} */ value) => value.toFixed(value < 1 ? 2 : 1);

export function widthSpoken(/** @type {number} */ value) {
  const n = widthText(value);
  if (value < 0.995) return t("{n}, with gaps between the bumps", { n });
  if (value < 1.005) return t("1.0, the bumps just touch");
  return t("{n}, each bump covers the places of {n}", { n });
}

/**
 * How a goal ring is read aloud.
 * @param {string} label
 * @param {number[]} shift [m]
 */
export function ringName(label, [x, y]) {
  const n = (/** @type {number} */ value) => Math.abs(100 * value).toFixed(1);
  const moved = [];
  if (x <= -UNMOVED) moved.push(t("{n} centimetres left", { n: n(x) }));
  if (x >= UNMOVED) moved.push(t("{n} centimetres right", { n: n(x) }));
  if (y <= -UNMOVED) moved.push(t("{n} centimetres down", { n: n(y) }));
  if (y >= UNMOVED) moved.push(t("{n} centimetres up", { n: n(y) }));
  return {
    label: t("{goal}. Arrow keys move it, Home puts it back.", { goal: label }),
    now: Math.round(1000 * x),
    text: moved.join(", ") || t("as written"),
  };
}
