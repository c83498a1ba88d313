// Elements, controls and talk with Python that the panels and the scene share.

export const SVG = "http://www.w3.org/2000/svg";
const SVG_TAGS = new Set("svg g path circle line rect text clipPath defs title".split(" "));

/**
 * A widget's model, as anywidget hands it over.
 * @typedef {{
 *   get(name: string): any, set(name: string, value: any): void, save_changes(): void,
 *   on(events: string, listener: () => void): void,
 *   send?(content: object, callbacks?: any, buffers?: ArrayBuffer[]): void,
 *   widget_manager?: any,
 * }} Model
 */
/** @typedef {{ model: Model, el: HTMLElement, host?: any, signal?: AbortSignal }} Widget */
/**
 * @typedef {HTMLElementTagNameMap
 *   & Omit<SVGElementTagNameMap, keyof HTMLElementTagNameMap>} Tags
 */
/**
 * @typedef {{ value: string, label: string, name?: string, group?: string, asks?: boolean }} Option
 */

/**
 * An element with attributes and children; a child that is null is left out.
 * @template {keyof Tags} T
 * @param {T} tag
 * @param {Record<string, any>} attributes
 * @param {...(Node | string | null)} children
 * @returns {Tags[T]}
 */
export function make(tag, attributes = {}, ...children) {
  const node = SVG_TAGS.has(tag) ? document.createElementNS(SVG, tag) : document.createElement(tag);
  node.append(...children.filter((child) => child !== null));
  return /** @type {any} */ (change(node, attributes));
}

/**
 * Set attributes; one that is null, undefined or false is taken away, functions become listeners.
 * @template {Element} T
 * @param {T} node
 * @param {Record<string, any>} attributes
 */
export function change(node, attributes) {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") node.addEventListener(name, value);
    else if (value === null || value === undefined || value === false) node.removeAttribute(name);
    else node.setAttribute(name, value === true ? "" : value);
  }
  return node;
}

/**
 * Mark a control that Python answers: a page without a kernel shows it disabled.
 * @template {Element} T
 * @param {T} node
 */
export function asking(node) {
  return change(node, { "data-dt-asks": true });
}

/**
 * Keep keys from the notebook, which would take arrows, A, B, D or X for its own commands.
 * Those with Ctrl or Meta pass: Ctrl+S saves the notebook. Jupyter Notebook looks at keys before
 * anybody else, and leaves alone what has the focus and this attribute.
 * @template {Element} T
 * @param {T} node
 */
export function keepKeys(node) {
  const keep = (/** @type {any} */ event) => {
    const isKept = !event.ctrlKey && !event.metaKey;
    event.target.toggleAttribute("data-lm-suppress-shortcuts", isKept);
    return isKept;
  };
  const keydown = (/** @type {KeyboardEvent} */ event) => {
    if (keep(event)) event.stopPropagation();
  };
  return change(node, { keydown, keyup: keep, focusin: keep });
}

/** An id that no other panel of the page has, though each loads its own copy of this module. */
export function newId(/** @type {string} */ word) {
  const page = /** @type {{ __dtIds?: number }} */ (globalThis);
  page.__dtIds = (page.__dtIds ?? 0) + 1;
  return `dt-${word}-${page.__dtIds}`;
}

/**
 * One of several: radio buttons that look like one bar.
 * @param {{
 *   legend: string, options: Option[], value?: string | number, kind?: string,
 *   onChange: (value: string) => void,
 * }} what
 */
export function choice({ legend, options, value, onChange, kind = "dt-choice" }) {
  const group = newId("choice");
  const inputs = options.map((option) =>
    make("input", { type: "radio", name: group, value: option.value, "aria-label": option.name }),
  );
  const labels = options.map(({ label, name, asks }, i) => {
    const node = make("label", { title: name }, inputs[i], make("span", {}, label));
    return asks ? asking(node) : node;
  });
  const node = make("fieldset", { class: kind }, make("legend", {}, legend), ...labels);
  for (const input of inputs) input.addEventListener("change", () => onChange(input.value));
  const show = (/** @type {string | number} */ chosen) => {
    for (const input of inputs) input.checked = input.value === String(chosen);
  };
  show(value);
  return { node, show };
}

/**
 * One of many: a list that opens, in groups. With a heading its name is its first line, chosen
 * where none of the others is.
 * @param {{
 *   name: string, options: Option[], value?: string, kind?: string, heading?: boolean,
 *   onChange: (value: string) => void,
 * }} what
 */
export function list({ name, options, value, onChange, kind = "dt-list", heading = true }) {
  const inside = (/** @type {string} */ group) =>
    options
      .filter((option) => (option.group ?? "") === group)
      .map((option) =>
        make("option", { value: option.value, "aria-label": option.name }, option.label),
      );
  const items = [...new Set(options.map((option) => option.group ?? ""))].flatMap((label) =>
    label ? [make("optgroup", { label }, ...inside(label))] : inside(label),
  );
  const first = heading ? make("option", { value: "", disabled: true }, name) : null;
  const node = make("select", { class: kind, "aria-label": name }, first, ...items);
  node.addEventListener("change", () => onChange(node.value));
  const show = (/** @type {string} */ chosen) => {
    node.value = options.some((option) => option.value === chosen) ? chosen : "";
  };
  show(value);
  return { node, show };
}

/**
 * Set traits and send them to Python.
 * @param {Model} model
 * @param {Record<string, any>} values
 */
export function save(model, values) {
  for (const [name, value] of Object.entries(values)) model.set(name, value);
  model.save_changes();
}

/**
 * Call listeners when traits change; a listener's name is that of its trait, or of several.
 * @param {Model} model
 * @param {Record<string, () => void>} listeners
 */
export function hear(model, listeners) {
  for (const [names, listener] of Object.entries(listeners)) {
    model.on(names.replace(/\S+/g, "change:$&"), listener);
  }
}

/**
 * A function that is called again only where one of its arguments is another one.
 * @template {any[]} A
 * @template R
 * @param {(...given: A) => R} work
 */
export function once(work) {
  /** @type {A | null} */
  let last = null;
  /** @type {R} */
  let kept;
  return (/** @type {A} */ ...given) => {
    if (!last || given.some((each, i) => each !== last[i])) {
      kept = work(...given);
      last = given;
    }
    return kept;
  };
}
