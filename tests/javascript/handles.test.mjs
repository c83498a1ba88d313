import assert from "node:assert/strict";
import { test } from "node:test";
import { parseHTML } from "linkedom";

const { document, Event } = parseHTML("<!doctype html><html><body></body></html>");
Object.assign(globalThis, { document });
const { Handles } = await import("../../dmp_teach/classroom/panels/handles.js");

// Ten pixels are one; up is up.
const VIEW = {
  w: 100,
  h: 100,
  px: ([x, y]) => [10 * x, 100 - 10 * y],
  metres: ([x, y]) => [x / 10, (100 - y) / 10],
};

function bet(axis, count = 5) {
  const heard = [];
  const handles = new Handles({ onHandle: (i, at, isDone) => heard.push([i, at, isDone]) });
  const scene = Array.from({ length: count }, (_, i) => ({
    at: [2 * i + 1, 5],
    first: [2 * i + 1, 5],
    label: `Point ${i + 1}`,
    text: "5 mm",
    axis,
    step: 0.1,
  }));
  handles.draw(scene, VIEW);
  const knobs = [...handles.knobs.children];
  const press = (i, key, shiftKey = false) => {
    const event = Object.assign(new Event("keydown", { bubbles: true }), { key, shiftKey });
    knobs[i].dispatchEvent(event);
  };
  return { handles, heard, scene, knobs, press };
}

const text = (knob) => knob.getAttribute("aria-valuetext");

test("each handle is a slider with a name, and says that it was not moved yet", () => {
  const { knobs, press } = bet("y");
  assert.deepEqual(
    knobs.map((knob) => [knob.getAttribute("role"), knob.getAttribute("aria-label")])[4],
    ["slider", "Point 5"],
  );
  assert.equal(text(knobs[1]), "5 mm, not moved yet");
  press(1, "ArrowUp");
  assert.equal(text(knobs[1]), "5 mm");
  assert.equal(knobs[1].getAttribute("aria-valuenow"), "5.1");
  assert.equal(knobs.filter((knob) => knob.getAttribute("tabindex") === "0").length, 1);
});

test("keys move a handle up and down, or all four ways, within its ground", () => {
  const row = bet("y");
  for (const [key, shift] of [["ArrowDown", true], ["Home"], ["ArrowDown"], ["End"]]) {
    row.press(2, key, shift);
  }
  assert.deepEqual(
    row.heard.map(([i, at, isDone]) => [i, ...at, isDone]),
    [4, 0, 0, 10].map((y) => [2, 5, y, true]),
  );
  const sheet = bet("xy");
  sheet.press(0, "ArrowLeft");
  sheet.press(0, "ArrowLeft", true);
  assert.deepEqual(
    sheet.heard.map(([, at]) => at),
    [
      [0.9, 5],
      [0, 5],
    ],
  );
});

test("a hand across a row paints it, and nothing is done before it lets go", () => {
  const { handles, heard, scene } = bet("y");
  handles.press([12, 20]);
  handles.move([
    [50, 40],
    [72, 10],
  ]);
  handles.draw(scene, VIEW);
  assert.deepEqual([...new Set(heard.map(([i]) => i))], [0, 1, 2, 3]);
  assert.ok(heard.every(([i, at, isDone]) => at[0] === 2 * i + 1 && !isDone));
  assert.equal(handles.handles[3].at[1], 9);
  handles.drop();
  assert.deepEqual(heard.at(-1), [3, [7, 9], true]);
});

test("a hand that lets go without a move has said nothing", () => {
  for (const [axis, at] of [
    ["y", [10, 50]],
    ["xy", [50, 5]],
  ]) {
    const { handles, heard } = bet(axis);
    assert.ok(handles.press(at));
    handles.drop();
    assert.deepEqual(heard, []);
  }
});

test("a stroke on empty ground lays all handles along it", () => {
  const { handles, heard } = bet("xy");
  handles.press([10, 10]);
  handles.move([[30, 10]]);
  assert.deepEqual(heard, []);
  handles.move([[90, 10]]);
  handles.drop();
  assert.deepEqual(
    handles.handles.map(({ at }) => at),
    [1, 3, 5, 7, 9].map((x) => [x, 9]),
  );
  assert.ok(handles.handles.length && heard.at(-1)[2]);
});

test("a dash in the middle is no line: it is taken back, and said; a long line is one", () => {
  const far = { w: 600, h: 100, px: ([x, y]) => [60 * x, 100 - 10 * y] };
  const view = { ...far, metres: ([x, y]) => [x / 60, (100 - y) / 10] };
  const { handles, heard, scene } = bet("xy");
  const seen = [...scene];
  handles.onHandle = (i, at, isDone) => {
    heard.push([i, at, isDone]);
    seen[i] = { ...seen[i], at };
    handles.draw(seen, view);
  };
  let said = 0;
  handles.onShort = () => {
    said += 1;
  };
  handles.draw(scene, view);
  const draw = (from, to) => {
    handles.press(from);
    handles.move([to]);
    handles.drop();
  };
  draw([300, 50], [350, 50]);
  assert.equal(said, 1);
  assert.deepEqual(
    handles.handles.map(({ at }) => at),
    scene.map(({ at }) => at),
  );
  assert.ok(heard.every(([, , isDone]) => !isDone));
  assert.match(text(handles.knobs.children[0]), /not moved yet/);
  draw([140, 50], [560, 50]);
  draw([145, 50], [175, 90]);
  assert.equal(said, 1);
  assert.equal(heard.filter(([, , isDone]) => isDone).length, 2);
  const line = handles.handles.map(({ at }) => at);
  draw([100, 50], [130, 50]);
  assert.equal(said, 2);
  assert.deepEqual(
    handles.handles.map(({ at }) => at),
    line,
  );
  assert.doesNotMatch(text(handles.knobs.children[4]), /not moved yet/);
});

test("a bet that was made before the page was loaded anew is moved by its handles", () => {
  const { handles, scene, knobs } = bet("xy");
  handles.draw(
    scene.map((each) => ({ ...each, at: [each.at[0], 7] })),
    VIEW,
  );
  assert.equal(text(knobs[2]), "5 mm");
  handles.press([50, 30]);
  handles.move([[50, 10]]);
  handles.drop();
  assert.deepEqual(
    handles.handles.map(({ at }) => at[1]),
    [7, 7, 9, 7, 7],
  );
});

test("a line is drawn from its first handle, and again; later ones are moved", () => {
  const { handles } = bet("xy");
  const draw = (from, to) => {
    handles.press(from);
    handles.move([to]);
    handles.drop();
    return handles.handles.map(({ at }) => at);
  };
  assert.deepEqual(draw([50, 50], [50, 90])[4], [5, 1]);
  assert.deepEqual(
    draw([50, 50], [90, 50]),
    [5, 6, 7, 8, 9].map((x) => [x, 5]),
  );
  assert.deepEqual(draw([70, 50], [70, 20]).slice(1, 4), [
    [6, 5],
    [7, 8],
    [8, 5],
  ]);
});

test("each of two handles is pulled alone, and a stroke elsewhere lays both", () => {
  const { handles } = bet("xy", 2);
  const draw = (from, to) => {
    handles.press(from);
    handles.move([to]);
    handles.drop();
    return handles.handles.map(({ at }) => at);
  };
  const view = { ...VIEW, px: ([x, y]) => [60 * x, 100 - 10 * y] };
  handles.draw(handles.handles, { ...view, w: 600, metres: ([x, y]) => [x / 60, (100 - y) / 10] });
  assert.deepEqual(draw([180, 50], [240, 50]), [
    [1, 5],
    [4, 5],
  ]);
  assert.deepEqual(draw([60, 50], [120, 50]), [
    [2, 5],
    [4, 5],
  ]);
  assert.deepEqual(draw([300, 90], [360, 90]), [
    [5, 1],
    [6, 1],
  ]);
});
