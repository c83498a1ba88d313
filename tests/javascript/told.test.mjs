import assert from "node:assert/strict";
import { test } from "node:test";
import { told } from "../../dmp_teach/views/told.js";

class Observer {
  observe() {}
}
const matchMedia = () => new EventTarget();
Object.assign(globalThis, { MutationObserver: Observer, ResizeObserver: Observer, matchMedia });

/** A widget whose Python speaks by `say`; `known` are traits that Jupyter keeps, too. */
function widgetOf(known = {}) {
  globalThis.document = { body: { dataset: {} } };
  const heard = {};
  const sent = [];
  const model = {
    get: (name) => known[name],
    set: (name, value) => {
      known[name] = value;
    },
    on: (event, listener) => {
      heard[event] = listener;
    },
    save_changes: () => sent.push({ ...known }),
    send: (message) => sent.push(message),
  };
  const say = (traits, more = {}, buffers = []) =>
    heard["msg:custom"]({ kind: "traits", json: JSON.stringify(traits), ...more }, buffers);
  const shown = {};
  const widget = told(({ model }) => Object.assign(shown, { model }))();
  widget.initialize({ model });
  const el = { replaceChildren() {} };
  return { say, sent, heard, shown, render: () => widget.render({ model, el }) };
}

test("a panel is drawn when all of its traits have come, with bytes where bytes were", async () => {
  const { say, shown, render } = widgetOf();
  const drawn = render();
  say({ late: 1 }, { isWhole: false });
  await null;
  assert.deepEqual(shown, {});
  const bytes = new DataView(new ArrayBuffer(8));
  say({ ink: { buffer: 0 }, n: 3, none: null }, { isWhole: true }, [bytes]);
  await drawn;
  assert.equal(shown.model.get("ink"), bytes);
  assert.deepEqual([shown.model.get("n"), shown.model.get("none")], [3, null]);
});

test("nobody hears of one trait before all of a message are set", async () => {
  const { say, shown, render } = widgetOf();
  say({ a: 1, b: 1 }, { isWhole: true });
  await render();
  const seen = [];
  shown.model.on("change:a change:b", () => seen.push(shown.model.get("a") + shown.model.get("b")));
  say({ a: 2, b: 2 });
  assert.deepEqual(seen, [4, 4]);
});

test("a page that came late asks, and an answer to another page is not for it", async () => {
  const { say, sent, shown, render } = widgetOf();
  const drawn = render();
  await new Promise((resolve) => setTimeout(resolve, 400));
  assert.equal(sent[0].kind, "traits");
  say({ n: 1 }, { isWhole: true, asker: 2 });
  say({ n: 5 }, { isWhole: true, asker: sent[0].asker });
  await drawn;
  assert.equal(shown.model.get("n"), 5);
});

test("what the browser sets is told to Python, and what a linked slider sets is heard", async () => {
  const known = { n: 3 };
  const { say, sent, heard, shown, render } = widgetOf(known);
  say({ n: 3, ink: 1 }, { isWhole: true });
  await render();
  shown.model.set("n", 4);
  shown.model.save_changes();
  assert.deepEqual(sent, [{ n: 4 }]);
  known.n = 9;
  heard["change:n"]();
  assert.equal(shown.model.get("n"), 9);
  assert.equal(heard["change:ink"], undefined);
});

test("what another window has asked for is seen here, and what this one is ahead of is not", async () => {
  const known = { asked: 3, n: 12 };
  const { say, shown, render } = widgetOf(known);
  say({ asked: 3, n: 12, line: 0 }, { isWhole: true });
  await render();
  const seen = [];
  shown.model.on("change:line", () => seen.push([shown.model.get("n"), known.n]));
  say({ line: 1 }, { knobs: { asked: 3, n: 11 } });
  say({ line: 2 }, { knobs: { asked: 4, n: 13 } });
  assert.deepEqual(seen[0], [12, 12]);
  assert.deepEqual([seen[1][0], known.n, known.asked], [13, 13, 4]);
});
