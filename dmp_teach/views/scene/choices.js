// What one can choose of the view: the camera, what is shown of a run, and the speed.

import { choice, list, save } from "../dom.js";
import { t } from "../texts.js";

/** @typedef {import("../dom.js").Option} Option */

const cameraOptions = () => [
  { value: "whole robot", label: t("Whole robot") },
  { value: "over the shoulder", label: t("Over the shoulder") },
  { value: "page from above", label: t("Page from above") },
];
const seenOptions = () => [
  { value: "as planned", label: t("as planned") },
  { value: "as it happened", label: t("as it happened") },
];
const SPEEDS = [
  { value: "1", label: "1×" },
  { value: "0.5", label: "½×" },
  { value: "0.25", label: "¼×" },
];

/**
 * The camera and what is shown each have a bar and, where there is little room, a list.
 * @param {import("../dom.js").Model} model
 */
export function choices(model) {
  const bar = (
    /** @type {string} */ legend,
    /** @type {Option[]} */ options,
    /** @type {(value: string) => void} */ onChange,
  ) => choice({ legend, options, onChange, kind: "dts-choice" });
  const both = (
    /** @type {string} */ name,
    /** @type {Option[]} */ options,
    /** @type {string} */ trait,
  ) => {
    const onChange = (/** @type {string} */ value) => save(model, { [trait]: value });
    const small = list({ name, options, onChange, kind: "dts-list", heading: false });
    return [bar(name, options, onChange), small];
  };
  return {
    cameras: both(t("Camera"), cameraOptions(), "camera"),
    sights: both(t("What is shown"), seenOptions(), "seen"),
    speeds: bar(t("Speed"), SPEEDS, (value) => save(model, { speed: Number(value) })),
  };
}
