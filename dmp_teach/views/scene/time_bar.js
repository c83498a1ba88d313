// Play, the time slider and the time in words.

import { make, newId } from "../dom.js";
import { t } from "../texts.js";

const faces = () => ({
  play: { name: t("Play"), path: "M8 5.5v13l11-6.5z" },
  pause: { name: t("Pause"), path: "M8 5.5h3v13H8zM14 5.5h3v13h-3z" },
  next: { name: t("Next picture"), path: "M6 5.5v13l8-6.5zM16 5.5h2.5v13H16z" },
});
/** @type {Record<string, number>} */
const WAYS = {
  ArrowRight: 0.1,
  ArrowUp: 0.1,
  ArrowLeft: -0.1,
  ArrowDown: -0.1,
  PageUp: 1,
  PageDown: -1,
};

export class TimeBar {
  /** @param {{ onPlay(): void, onTime(time: number): void, onDone(): void }} listeners */
  constructor({ onPlay, onTime, onDone }) {
    const id = newId("time");
    this.shape = make("path", { fill: "currentColor" });
    const drawing = make("svg", { viewBox: "0 0 24 24", "aria-hidden": "true" }, this.shape);
    const look = { type: "button", class: "dts-play", click: onPlay };
    this.button = make("button", look, drawing);
    this.slider = make("input", { id, type: "range", min: 0, max: 1, step: 0.001, value: 0 });
    this.words = make("output", { for: id, "aria-hidden": "true" });
    const label = make("label", { for: id, class: "dts-hidden" }, t("Time"));
    this.node = make("div", { class: "dts-bar" }, this.button, label, this.slider, this.words);
    this.slider.addEventListener("input", () => onTime(Number(this.slider.value)));
    this.slider.addEventListener("change", onDone);
    this.slider.addEventListener("keydown", (event) => {
      const way = WAYS[event.key];
      if (!way) return;
      event.preventDefault();
      onTime(Math.round((Number(this.slider.value) + way) * 10) / 10);
      onDone();
    });
  }

  /**
   * @param {number} time [s]
   * @param {number} duration [s]
   */
  show(time, duration) {
    this.slider.max = String(duration || 1);
    this.slider.value = String(time);
    const part = duration ? (100 * time) / duration : 0;
    this.slider.style.setProperty("--part", `${part}%`);
    const [now, end] = [time.toFixed(1), duration.toFixed(1)];
    this.slider.setAttribute("aria-valuetext", t("{now} of {end} seconds", { now, end }));
    this.words.textContent = t("{now} s of {end} s", { now, end });
  }

  /** What the button does at a press. */
  face(/** @type {keyof ReturnType<typeof faces>} */ kind) {
    const { name, path } = faces()[kind];
    this.shape.setAttribute("d", path);
    this.button.setAttribute("aria-label", name);
    this.button.title = name;
  }

  enable(/** @type {boolean} */ on) {
    this.button.disabled = !on;
    this.slider.disabled = !on;
  }
}
