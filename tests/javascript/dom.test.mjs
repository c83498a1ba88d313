import assert from "node:assert/strict";
import { test } from "node:test";
import { parseHTML } from "linkedom";

const { document, Event } = parseHTML("<!doctype html><html><body></body></html>");
Object.assign(globalThis, { document });
const DOM = "../../dmp_teach/views/dom.js";
const { change, choice, keepKeys, make } = await import(DOM);
const OPTIONS = [
  { value: "a", label: "a" },
  { value: "1", label: "1" },
];

test("attributes are set, taken away, or listened to", () => {
  const clicks = [];
  const node = make(
    "button",
    { title: "x", disabled: true, click: () => clicks.push(1) },
    "Go",
    null,
  );
  assert.equal(node.outerHTML, '<button disabled title="x">Go</button>');
  node.dispatchEvent(new Event("click"));
  assert.equal(clicks.length, 1);
  assert.equal(change(node, { title: null, disabled: false }).outerHTML, "<button>Go</button>");
});

test("two copies of the module on one page share neither ids nor groups", async () => {
  const names = new Set();
  for (const copy of [await import(`${DOM}?first`), await import(`${DOM}?second`)]) {
    names.add(copy.newId("slider"));
    const bar = copy.choice({ legend: "Letter", options: OPTIONS, onChange() {} });
    names.add(bar.node.querySelector("input").getAttribute("name"));
  }
  assert.equal(names.size, 4);
});

test("keys stay in the panel, those with Ctrl or Meta pass", () => {
  const seen = [];
  const panel = keepKeys(make("div", {}, make("input")));
  document.body.append(panel);
  document.body.addEventListener("keydown", (event) => seen.push(event.key));
  for (const keys of [
    { key: "d" },
    { key: "s", ctrlKey: true },
    { key: "s", metaKey: true },
    { key: "D", shiftKey: true },
  ]) {
    const event = Object.assign(new Event("keydown", { bubbles: true }), keys);
    panel.querySelector("input").dispatchEvent(event);
  }
  assert.deepEqual(seen, ["s", "s"]);
});

test("a bar shows one of its options and tells which was chosen", () => {
  const chosen = [];
  const bar = choice({
    legend: "L",
    options: OPTIONS,
    value: 1,
    onChange: (value) => chosen.push(value),
  });
  const inputs = [...bar.node.querySelectorAll("input")];
  assert.deepEqual(
    inputs.map((input) => Boolean(input.checked)),
    [false, true],
  );
  inputs[0].dispatchEvent(new Event("change"));
  assert.deepEqual(chosen, ["a"]);
});
