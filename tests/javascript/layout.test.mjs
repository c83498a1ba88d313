import assert from "node:assert/strict";
import { test } from "node:test";
import {
  badgePlaces,
  LETTER,
  labelPlace,
  outside,
  rulerLength,
  startLabels,
  viewOf,
} from "../../dmp_teach/classroom/panels/layout.js";

const VIEW = viewOf([-0.1, -0.1, 0.1, 0.1], [300, 200]);
const DOT = [[[0, 0]]];

const apart = ([x, y], [u, v]) => Math.hypot(x - u, y - v);

test("a pixel is the place that it shows, there and back", () => {
  for (const place of [
    [0, 0],
    [0.03, -0.07],
  ]) {
    assert.ok(apart(VIEW.metres(VIEW.px(place)), place) < 1e-12);
  }
});

test("the whole box is seen, and up is up", () => {
  assert.deepEqual(VIEW.px([0, 0.1]), [150, 0]);
  assert.deepEqual(VIEW.px([0, -0.1]), [150, 200]);
});

test("paper is turned with the clock, and ink stays where it is on the paper", () => {
  const box = [-0.1, -0.1, 0.1, 0.1];
  const turned = viewOf(box, [300, 200], Math.PI / 6);
  for (const place of [
    [0.01, 0.02],
    [-0.04, 0.09],
  ]) {
    assert.ok(apart(turned.metres(turned.px(place)), place) < 1e-12);
  }
  const [[x0, y0], [x1, y1]] = [turned.px([0, 0]), turned.px([0.05, 0])];
  assert.ok(Math.abs(Math.atan2(y1 - y0, x1 - x0) - Math.PI / 6) < 1e-9);
  assert.ok(Math.abs(apart([x0, y0], [x1, y1]) - 0.05 * turned.k) < 1e-9);
  assert.equal(turned.k, viewOf(box, [300, 200]).k);
});

test("the ruler has whole centimetres and is long enough to be read", () => {
  for (const k of [100, 700, 3000, 9000]) {
    const cm = rulerLength({ k });
    assert.ok(cm * 0.01 * k > 48 && [1, 2, 5, 10, 20, 50].includes(cm));
  }
});

test("starts that lie on each other share one label", () => {
  const strokes = [[[0, 0]], [[0.001, 0]], [[0.08, 0.08]]];
  const labels = startLabels(VIEW, strokes, (number) => `start ${number}`);
  assert.deepEqual(
    labels.map((label) => label.words),
    ["start 1, 2", "start 3"],
  );
});

test("a label at the edge of the sheet turns inwards", () => {
  assert.equal(labelPlace(VIEW, [150, 100], DOT, 50)["text-anchor"], "start");
  assert.equal(labelPlace(VIEW, [298, 100], DOT, 50)["text-anchor"], "end");
});

test("no label is cut off, wherever its start is and however long it is", () => {
  for (const words of ["1", "start", "start 1, 2", "start 10, 11"]) {
    const wide = LETTER * words.length;
    for (let x = 2; x < VIEW.w; x += 7) {
      const { x: at, "text-anchor": anchor } = labelPlace(VIEW, [x, 100], DOT, wide);
      const left = at - { start: 0, middle: wide / 2, end: wide }[anchor];
      assert.ok(left >= 0 && left + wide <= VIEW.w, `${words} at ${x}`);
    }
  }
});

test("a line that has left the sheet is told its side and how far", () => {
  assert.equal(outside(VIEW, [[0, 0]]), null);
  assert.equal(outside(VIEW, []), null);
  const away = outside(VIEW, [
    [0, 0],
    [0, -0.15],
  ]);
  assert.equal(away.words, "5 cm further down");
  assert.equal(outside(VIEW, [[0.65, 0]]).words, "0.5 m further right");
});

test("numbers of goals that lie on each other keep apart, a single goal has none", () => {
  assert.deepEqual(badgePlaces(VIEW, [[0, 0]], DOT), [null]);
  const [first, second] = badgePlaces(
    VIEW,
    [
      [0, 0],
      [0, 0],
    ],
    DOT,
  );
  assert.ok(apart(first, second) > 28);
});
