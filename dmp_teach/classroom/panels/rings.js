// The rings of goals: they are dragged by mouse and finger, and moved by arrow keys.

import { change, make, newId, once } from "../../views/dom.js";
import { t } from "../../views/texts.js";
import { badgePlaces, wordPlace } from "./layout.js";

/** @typedef {import("./layout.js").Place} Place */
/** @typedef {import("./layout.js").View} View */
/**
 * @typedef {{
 *   onGoal(stroke: number, place: Place, isDone: boolean): void,
 *   onHome(stroke: number): void, onPick(stroke: number): void,
 * }} Listeners `onGoal` hears where a ring is moved [m], and when hand or key lets it go
 */

export const RING = 10;
// How far an arrow key moves a ring [m].
const STEP = 0.001;
const CATCH = 22;
const CROSS =
  `M${RING} 0A${RING} ${RING} 0 1 1 ${-RING} 0A${RING} ${RING} 0 1 1 ${RING} 0` +
  "M-16 0H-5M5 0H16M0 -16V-5M0 5V16";
/** @type {Record<string, Place>} */
const WAYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/**
 * Where each stroke's number stands beside its ring, or, where there is only one ring, its word.
 * @param {View} view
 * @param {Place[]} goals
 * @param {{ robot: Place[][], demo: Place[][] }} ink
 */
export function goalLabels(view, goals, { robot, demo }) {
  const badges = badgePlaces(view, goals, robot);
  // A letter of the word is about 9 pixels wide.
  const wide = 9 * t("goal").length;
  const word = goals.length === 1 ? wordPlace(view, goals[0], [...robot, ...demo], wide) : {};
  return { badges, word };
}

/**
 * One goal: it takes focus, arrow keys move it one step, 1 mm unless another is given (Shift ten),
 * Home puts it back.
 * @param {number} i
 * @param {{ goal(): Place, view(): View, step(): number | undefined }} here
 * @param {Listeners} listeners
 */
export function goalRing(i, here, listeners) {
  const node = drawRing();
  hearHand(node, i, here, listeners);
  hearKeys(node, i, here, listeners);
  const place = once(placeBadge);
  /**
   * @param {Place} at [px]
   * @param {{ label: string, word?: string, now: number, text: string, isFixed?: boolean }} name
   * @param {ReturnType<typeof goalLabels>} labels
   * @param {string} chosen
   */
  const show = ([x, y], { label, word, now, text, isFixed }, labels, chosen) => {
    change(node, { transform: `translate(${x.toFixed(2)} ${y.toFixed(2)})`, "aria-label": label });
    change(node, { "aria-valuenow": now, "aria-valuetext": text });
    change(node, { tabindex: isFixed ? -1 : 0, "aria-disabled": isFixed ? "true" : null });
    place(node, labels, i, chosen, word);
  };
  return { node, show };
}

/**
 * @param {SVGElement} node
 * @param {number} i
 * @param {{ goal(): Place, view(): View }} here
 * @param {Listeners} listeners
 */
function hearHand(node, i, here, { onGoal, onPick }) {
  /** @type {{ id: number, from: Place, goal: Place } | null} */
  let drag = null;
  const drop = () => {
    if (!drag) return;
    drag = null;
    onGoal(i, here.goal(), true);
  };
  node.addEventListener("pointerdown", (event) => {
    if (event.button) return;
    node.setPointerCapture(event.pointerId);
    drag = { id: event.pointerId, from: [event.clientX, event.clientY], goal: here.goal() };
    onGoal(i, drag.goal, false);
    event.preventDefault();
    // Chromium knows `focusVisible`; the ring of the keyboard is not wanted under a finger.
    node.focus(/** @type {any} */ ({ preventScroll: true, focusVisible: false }));
  });
  // Chromium heeds no `touch-action` inside an SVG: a finger on a ring would scroll the notebook.
  node.addEventListener("touchstart", (event) => event.preventDefault(), { passive: false });
  node.addEventListener("pointermove", (event) => {
    if (drag?.id !== event.pointerId) return;
    const { k } = here.view();
    const [right, down] = [event.clientX - drag.from[0], event.clientY - drag.from[1]];
    onGoal(i, [drag.goal[0] + right / k, drag.goal[1] - down / k], false);
  });
  node.addEventListener("pointerup", drop);
  node.addEventListener("pointercancel", drop);
  node.addEventListener("focus", () => drag || onPick(i));
}

/**
 * @param {SVGElement} node
 * @param {number} i
 * @param {{ goal(): Place, step(): number | undefined }} here
 * @param {Listeners} listeners
 */
function hearKeys(node, i, { goal, step }, { onGoal, onHome }) {
  let isHeld = false;
  node.addEventListener("keydown", (event) => {
    const way = WAYS[event.key];
    if (!way && event.key !== "Home") return;
    event.preventDefault();
    event.stopPropagation();
    if (!way) {
      onHome(i);
      return;
    }
    isHeld = true;
    const by = (event.shiftKey ? 10 : 1) * (step() ?? STEP);
    const [x, y] = goal();
    onGoal(i, [x + by * way[0], y + by * way[1]], false);
  });
  const letGo = () => {
    if (isHeld) onGoal(i, goal(), true);
    isHeld = false;
  };
  node.addEventListener("keyup", letGo);
  node.addEventListener("blur", letGo);
}

function drawRing() {
  const attributes = { id: newId("ring"), class: "dt-goal", tabindex: 0, role: "slider" };
  return make(
    "g",
    { ...attributes, "aria-valuemin": -1000, "aria-valuemax": 1000 },
    make("line", { class: "dt-rule dt-stalk" }),
    make("circle", { class: "dt-catch", r: CATCH }),
    make("circle", { class: "dt-halo", r: 17 }),
    make("circle", { class: "dt-focus", r: 17 }),
    make("path", { class: "dt-ring", d: CROSS }),
    make("circle", { class: "dt-catch dt-catch-badge", r: CATCH }),
    make("circle", { class: "dt-badge", r: 14 }),
    make("text", { class: "dt-count", dy: 5 }),
    make("text", { class: "dt-name" }),
  );
}

/**
 * Put a ring's number where it can be caught, or its word; where there is only one ring, a word.
 * @param {Element} ring
 * @param {ReturnType<typeof goalLabels>} labels
 * @param {number} i
 * @param {string} chosen
 * @param {string} [own] its word
 */
function placeBadge(ring, { badges, word }, i, chosen, own) {
  const badge = badges[i];
  const part = (/** @type {string} */ name) =>
    /** @type {SVGElement} */ (ring.querySelector(`.dt-${name}`));
  const names = ["stalk", "badge", "count", "catch-badge", "name"];
  const [stalk, dot, count, reach, words] = names.map(part);
  for (const node of [stalk, dot, count, reach]) node.style.display = badge ? "" : "none";
  words.style.display = badge ? "none" : "";
  if (own) dot.style.display = "none";
  if (!badge) {
    change(words, word).replaceChildren(own ?? t("goal"));
    return;
  }
  const [x, y] = badge;
  const end = (Math.hypot(x, y) - 14) / Math.hypot(x, y);
  change(stalk, { x1: x * 0.4, y1: y * 0.4, x2: x * end, y2: y * end });
  for (const node of [dot, reach]) change(node, { cx: x, cy: y });
  change(dot, { class: `dt-badge ${chosen}` });
  const look = own ? "dt-count dt-word" : `dt-count ${chosen}`;
  change(count, { x, y, class: look }).replaceChildren(own ?? String(i + 1));
}
