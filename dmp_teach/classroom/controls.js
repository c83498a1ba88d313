// The controls of every panel. Native inputs inside, so that names, keys and focus come with the browser.

const SVG = "http://www.w3.org/2000/svg";

/** An element with attributes and children; an attribute that is null, undefined or false is left out. */
function make(tag, attributes = {}, ...children) {
  const node = SVG_TAGS.has(tag) ? document.createElementNS(SVG, tag) : document.createElement(tag);
  change(node, attributes);
  node.append(...children.filter((child) => child !== null));
  return node;
}

const SVG_TAGS = new Set(["svg", "g", "path", "circle", "line", "rect", "text", "clipPath", "defs", "title"]);

/** Set, or take away, attributes; functions become event listeners. */
function change(node, attributes) {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") node.addEventListener(name, value);
    else if (value === null || value === undefined || value === false) node.removeAttribute(name);
    else node.setAttribute(name, value === true ? "" : value);
  }
  return node;
}

/** Keys pressed inside a panel are the panel's: JupyterLab would take arrows, A, B, D or X for its own commands. */
const keepKeys = (node) => change(node, { "data-lm-suppress-shortcuts": "true", keydown: (event) => event.stopPropagation() });

/** A small drawing of 24 by 24, in the colour of the text beside it. */
function icon(path, box = "0 0 24 24") {
  const line = make("path", { d: path, fill: "none", stroke: "currentColor", "stroke-width": 2, "stroke-linecap": "round", "stroke-linejoin": "round" });
  return make("svg", { viewBox: box, "aria-hidden": "true", focusable: "false" }, line);
}

const ICONS = {
  pen: "M4 20l1-4L16 5l3 3L8 19l-4 1M14 7l3 3",
  back: "M8 6L4 10l4 4M4 10h10a5 5 0 0 1 0 10h-3",
  tick: "M4 13l5 5L20 6",
  arrow: "M3 12h17M14 6l6 6-6 6",
  later: "M12 3a9 9 0 1 1-.1 0",
  warning: "M12 3L2 21h20L12 3M12 10v5M12 18v.2",
  pause: "M8 5v14M16 5v14",
  file: "M6 2h8l5 5v15H6V2M14 2v5h5",
};
const BUMPS = {
  one: "M1 20h5c5 0 5-17 11-17s6 17 11 17h5",
  many: "M1 20c4 0 3-17 6-17s3 17 5 17 2-17 5-17 3 17 5 17 2-17 5-17 2 17 6 17",
  narrow: "M1 20h12c3 0 2-17 4-17s1 17 4 17h12",
};
const bump = (name) => icon(BUMPS[name], "0 0 34 24");

let count = 0;
const newId = (word) => `dt-${word}-${(count += 1)}`;

/** One of several: radio buttons that look like one bar. Gives {node, show(value)}. */
function choice({ legend, options, value, onChange, kind = "" }) {
  const name = newId("choice");
  const inputs = options.map((option) => make("input", { type: "radio", name, value: option.value, "aria-label": option.name }));
  const labels = options.map((option, i) => make("label", { title: option.name }, inputs[i], make("span", {}, option.label)));
  const node = make("fieldset", { class: `dt-choice ${kind}` }, make("legend", {}, legend), ...labels);
  inputs.forEach((input) => input.addEventListener("change", () => onChange(input.value)));
  const show = (chosen) => inputs.forEach((input) => (input.checked = input.value === String(chosen)));
  show(value);
  return { node, show };
}

/** One of many: a list that opens, in groups. Its first line is its name, and is chosen where none of the others is. */
function list({ name, options, value, onChange }) {
  const groups = [...new Set(options.map((option) => option.group ?? ""))];
  const inside = (label) => options.filter((option) => (option.group ?? "") === label).map((option) => make("option", { value: option.value, "aria-label": option.name }, option.label));
  const items = groups.flatMap((label) => (label ? [make("optgroup", { label }, ...inside(label))] : inside(label)));
  const node = make("select", { class: "dt-list", "aria-label": name }, make("option", { value: "", disabled: true }, name), ...items);
  node.value = options.some((option) => option.value === value) ? value : "";
  node.addEventListener("change", () => onChange(node.value));
  return node;
}

/**
 * A slider with a plain name, the real word in grey, and its value.
 *
 * `scale` turns the value into the place of the thumb and back (log for widths); `text` is what is shown and
 * `spoken` what is read aloud; `zero` is where the blue part begins, and `mark` what is written there. Gives {node, input, show(value, low, high)}.
 */
function slider({ label, term, low, high, step, text, spoken, onInput, onDone, icons = [], scale = LINEAR, zero = null, mark = null }) {
  const id = newId("slider");
  const input = make("input", { id, type: "range", min: scale.place(low), max: scale.place(high), step: scale.step(step) });
  const output = make("output", { for: id, "aria-hidden": "true" });
  const name = make("label", { for: id }, label, make("small", {}, ` ${term}`));
  const tick = mark && make("span", { class: "dt-mark", "aria-hidden": "true" }, mark);
  const row = make("div", { class: "dt-row" }, icons[0] ?? null, make("div", { class: "dt-range" }, input, tick ?? null), icons[1] ?? null);
  const node = make("div", { class: "dt-slider" }, make("div", { class: "dt-top" }, name, output), row);
  const paint = () => {
    const value = scale.value(Number(input.value));
    const part = (place) => (place - input.min) / (input.max - input.min || 1);
    const home = zero === null ? Number(input.min) : scale.place(zero);
    const ends = [home, Number(input.value)].sort((a, b) => a - b);
    node.style.setProperty("--from", zero === null ? -1 : part(ends[0]));
    node.style.setProperty("--to", part(ends[1]));
    node.style.setProperty("--home", part(home));
    output.textContent = text(value);
    input.setAttribute("aria-valuetext", spoken(value));
  };
  input.addEventListener("input", () => (paint(), onInput(scale.value(Number(input.value)))));
  input.addEventListener("change", () => onDone && onDone());
  const show = (value, newLow = low, newHigh = high) => {
    change(input, { min: scale.place(newLow), max: scale.place(newHigh) });
    input.value = scale.place(value);
    paint();
  };
  return { node, input, show };
}

const LINEAR = { place: (value) => value, value: (place) => place, step: (step) => step };

/** Equal steps are equal factors; two figures are kept, and the thumb is drawn to the landmarks. */
const LOG = {
  place: (value) => Math.round(1000 * Math.log10(value)) / 1000,
  value: (place) => {
    const value = 10 ** place;
    const near = [2 / 3, 1, 4, 20].find((mark) => Math.abs(value / mark - 1) < 0.02);
    return near ?? Number(value.toPrecision(2));
  },
  step: () => 0.02,
};

/** A button of 44 px or more. */
function button(words, { onClick, drawing = null, main = false } = {}) {
  return make("button", { type: "button", class: main ? "dt-button dt-main" : "dt-button", click: onClick }, drawing, make("span", {}, words));
}

/** Words that are read aloud are put there once: the same words again would be read again. */
const put = (node, words) => node.textContent === words || (node.textContent = words);

/** Words that are heard and not seen. */
function spokenBox() {
  return make("div", { class: "dt-spoken", "aria-live": "polite", style: "position:absolute;width:1px;height:1px;overflow:hidden;clip-path:inset(50%)" });
}

/** The one number and the one sentence; spoken half a second after the last change, never during a drag. */
function sentence() {
  const number = make("div", { class: "dt-number", "aria-hidden": "true" });
  const words = make("div", { class: "dt-sentence", "aria-hidden": "true" });
  const spoken = spokenBox();
  const node = make("div", { class: "dt-box" }, number, words, spoken);
  let timer = null;
  const show = ({ number: figure, unit, text, strong, after }) => {
    number.hidden = !figure;
    number.replaceChildren(figure.replace("under ", "< "), make("small", {}, ` ${unit}`));
    words.replaceChildren(make("span", {}, text, make("b", {}, strong), after));
    clearTimeout(timer);
    timer = setTimeout(() => put(spoken, `${figure && `${figure} ${unit}. `}${text}${strong}${after}`), 500);
  };
  return { node, show };
}
