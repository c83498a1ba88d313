// The card of a step: what to do now, in one place above the pictures, with its one main button.

import { asking, change, choice, make } from "../../views/dom.js";
import { t } from "../../views/texts.js";
import { button, ICONS, icon, put, spokenBox } from "../panels/controls.js";

/** @typedef {Record<string, any>} Values */

const BULB =
  "M9 18h6M10 21h4M12 3a6 6 0 0 1 4 10.5c-1 1-1 1.5-1 2.5H9c0-1 0-1.5-1-2.500A6 6 0 0 1 12 3";

export class Card {
  /**
   * @param {Values} spec
   * @param {{ send(message: object): void, write: (() => void) | null,
   *   bet(): number[][] | null }} listeners `write` is null where no robot can
   */
  constructor(spec, { send, write, bet }) {
    this.spec = spec;
    this.canWrite = write !== null;
    this.words = make("div", { class: "dt-card-words" });
    this.buttons = make("div", { class: "dt-card-buttons" });
    this.spoken = spokenBox();
    this.node = make("section", { class: "dt-card" }, this.words, this.buttons, this.spoken);
    const step = (/** @type {string} */ name) => () => send({ kind: "step", step: name });
    const main = (/** @type {string} */ words, /** @type {() => void} */ onClick) =>
      button(words, { main: true, onClick });
    this.reveal = main(t("Lay the truth over it"), () => {
      if (this.reveal.getAttribute("aria-disabled")) return;
      if (spec.bet.handles) send({ kind: "bet", bet: bet() });
      send({ kind: "reveal" });
    });
    this.toTry = main(t("Now try it"), step("try"));
    this.toChallenge = main(t("To the challenge"), step("challenge"));
    this.check = main(t("Check"), () => send({ kind: "check" }));
    this.hint = button(t("Show a hint"), {
      drawing: icon(BULB),
      onClick: () => {
        send({ kind: "hint" });
        this.check.focus();
      },
    });
    this.write = main(t("Robot, write it"), write);
    this.write.prepend(icon(ICONS.pen));
    this.options = spec.bet.options && this.optionBar(send);
    this.buttons.append(...this.all(), this.write);
    for (const node of [this.toChallenge, this.check, this.hint, this.write]) asking(node);
  }

  all() {
    return [this.reveal, this.toTry, this.toChallenge, this.check, this.hint];
  }

  optionBar(/** @type {(message: object) => void} */ send) {
    const options = this.spec.bet.options.map((/** @type {string[]} */ [value, label, note]) => ({
      value,
      label: note ? make("span", {}, make("b", {}, label), make("small", {}, note)) : label,
    }));
    const onChange = (/** @type {string} */ value) => send({ kind: "bet", bet: value });
    return choice({ legend: this.spec.bet.question, options, onChange });
  }

  show(/** @type {Values} */ progress, /** @type {Values} */ card) {
    const { step, verdict } = progress;
    const isDone = Boolean(verdict?.done);
    const isHidden = step === "bet" && !progress.revealed;
    const hides = isHidden ? " dt-hides" : "";
    change(this.node, { class: `dt-card dt-${isDone ? "passed" : step}${hides}` });
    /** @type {Record<string, (progress: Values, card: Values) => Element[]>} */
    const draws = { bet: this.drawBet, try: this.drawTry, challenge: this.drawChallenge };
    const focused = /** @type {HTMLElement} */ (document.activeElement);
    const isHere = this.buttons.contains(focused);
    for (const each of [...this.all(), this.write]) each.hidden = true;
    // The room of a reason that is gone stays until the next check, so that nothing jumps.
    const { offsetHeight, style } = this.node;
    const room = this.words.querySelector(".dt-reason") ? `${offsetHeight}px` : style.minHeight;
    style.minHeight = step === "challenge" && !verdict ? room : "";
    const run = card.run ? [make("p", { class: "dt-reason" }, card.run)] : [];
    this.words.replaceChildren(...draws[step].call(this, progress, card), ...run);
    // The reason and the newest hint are the last words.
    if (verdict && !isDone) this.words.scrollTop = this.words.scrollHeight;
    const isLong = this.words.scrollHeight > this.words.clientHeight + 1;
    change(this.words, { tabindex: isLong ? "0" : null });
    /** @type {HTMLElement | null} */
    const first = this.buttons.querySelector(".dt-button:not([hidden])");
    // Even a button that is back at once may have lost the focus.
    if (isHere) (focused.hidden ? first : focused)?.focus();
    put(this.spoken, this.words.textContent);
  }

  /**
   * @param {Values} progress
   * @param {Values} card
   */
  drawBet({ bet, revealed }, card) {
    const { question } = this.spec.bet;
    const ready = bet !== null;
    this.reveal.hidden = revealed;
    change(this.reveal, { "aria-disabled": ready ? null : "true" });
    this.toTry.hidden = !revealed;
    this.options?.show(bet);
    const words = make("p", { class: "dt-ask" }, question);
    if (revealed) return [make("p", { class: "dt-ask" }, card.bet)];
    return [words, ...(this.options ? [this.options.node] : [])];
  }

  drawTry(/** @type {Values} */ { done }) {
    const { tasks, by_robot } = this.spec;
    const now = tasks.findIndex(
      (/** @type {string} */ _, /** @type {number} */ i) => !done.includes(i),
    );
    this.toChallenge.hidden = false;
    change(this.toChallenge, { class: now < 0 ? "dt-button dt-main" : "dt-button" });
    this.write.hidden = !by_robot.includes(true);
    change(this.write, { class: by_robot[now] ? "dt-button dt-main" : "dt-button" });
    return [
      make(
        "ol",
        { class: "dt-tasks" },
        ...tasks.map((/** @type {string} */ words, /** @type {number} */ i) => {
          const isDone = done.includes(i);
          const mark = isDone ? icon(ICONS.tick) : make("span", {}, String(i + 1));
          const kind = `${isDone ? "dt-is-done" : ""} ${i === now ? "dt-is-now" : ""}`;
          const said = isDone ? make("span", { class: "dt-unseen" }, t("done")) : null;
          return make("li", { class: kind }, mark, make("span", {}, words), said);
        }),
      ),
    ];
  }

  /**
   * @param {Values} progress
   * @param {Values} card
   */
  drawChallenge({ verdict, passed }, { rows, hints, offersHint, bet, run }) {
    const isDone = Boolean(verdict?.done);
    this.check.hidden = isDone;
    this.hint.hidden = !offersHint;
    this.write.hidden = !passed || !this.canWrite;
    change(this.write, { class: "dt-button dt-main" });
    const list = rows.map((/** @type {any[]} */ [name, shown, rule, isMet]) =>
      make(
        "li",
        { class: isMet ? "dt-met" : "" },
        icon(isMet ? ICONS.tick : ICONS.later),
        make("span", {}, name),
        make("b", {}, shown),
        make("small", {}, rule),
      ),
    );
    const told = hints.map((/** @type {string} */ words, /** @type {number} */ i) =>
      make("li", { class: i === hints.length - 1 ? "dt-newest" : "" }, ...bold(words)),
    );
    const badge = isDone
      ? make("span", { class: "dt-badge-done" }, icon(ICONS.tick), t("Done"))
      : null;
    return [
      make("p", { class: "dt-ask" }, badge, ...bold(isDone ? verdict.reason : this.spec.challenge)),
      make("ul", { class: "dt-rows" }, ...list),
      isDone && bet && !run ? make("p", { class: "dt-quiet" }, bet) : null,
      verdict && !isDone ? make("p", { class: "dt-reason" }, ...bold(verdict.reason)) : null,
      told.length && !isDone ? make("ol", { class: "dt-hints" }, ...told) : null,
    ].filter((each) => each !== null);
  }
}

/** Words, those between ** in bold. */
function bold(/** @type {string} */ words) {
  return words.split("**").map((part, i) => (i % 2 ? make("b", {}, part) : part));
}
