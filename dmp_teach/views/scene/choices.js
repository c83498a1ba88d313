// What one can choose of the view: the camera, what is shown of a run, and the speed.

import { choice, list, save } from "../dom.js";

/** @typedef {import("../dom.js").Option} Option */

const CAMERAS = [
  { value: "whole robot", label: "Whole robot" },
  { value: "over the shoulder", label: "Over the shoulder" },
  { value: "page from above", label: "Page from above" },
];
const SEEN = [
  { value: "as planned", label: "as planned" },
  { value: "as it happened", label: "as it happened" },
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
    cameras: both("Camera", CAMERAS, "camera"),
    sights: both("What is shown", SEEN, "seen"),
    speeds: bar("Speed", SPEEDS, (value) => save(model, { speed: Number(value) })),
  };
}
