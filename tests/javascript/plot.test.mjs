import assert from "node:assert/strict";
import { test } from "node:test";
import { equalized } from "../../dmp_teach/classroom/panels/axes.js";
import { alongStroke, nearest, painted } from "../../dmp_teach/classroom/panels/hand.js";
import {
  logTicks,
  niceTicks,
  pathOf,
  scaleOf,
  spread,
  ticksOf,
} from "../../dmp_teach/classroom/panels/scales.js";

const SQUARE = [
  [0, 0],
  [3, 0],
  [3, 3],
];
const ROW = [0, 10, 20, 30].map((x) => [x, 50]);

test("a pixel is the value that it shows, there and back, and up is up", () => {
  for (const log of [false, true]) {
    const { px, value } = scaleOf({ low: 0.5, high: 50, log }, 200, 20);
    assert.equal(px(0.5), 200);
    assert.equal(px(50), 20);
    for (const each of [0.7, 3, 44]) assert.ok(Math.abs(value(px(each)) - each) < 1e-9);
  }
});

test("equal factors are equally far on a logarithmic axis, and nothing is nowhere", () => {
  const { px, moved } = scaleOf({ low: 0.1, high: 1000, log: true }, 0, 400);
  assert.ok(Math.abs(px(1) - 100) < 1e-9 && Math.abs(px(10) - 200) < 1e-9);
  assert.ok(Number.isFinite(px(0)) && px(0) < 0);
  assert.equal(moved(5, 1), 50);
  assert.equal(scaleOf({ low: 0, high: 1 }, 0, 400).moved(0.1, 0.2), 0.3);
});

test("ticks are round, within the axis, and no more than there is room for", () => {
  assert.deepEqual(niceTicks(0, 2.9, 8), [0, 0.5, 1, 1.5, 2, 2.5]);
  assert.deepEqual(niceTicks(-2, 2, 5), [-2, -1, 0, 1, 2]);
  for (const [low, high] of [
    [-0.037, 0.081],
    [3, 17],
    [0, 1e-5],
    [-4000, 9000],
  ]) {
    const ticks = niceTicks(low, high, 6);
    assert.ok(ticks.length >= 2 && ticks.length <= 7);
    assert.ok(ticks.every((value) => value >= low && value <= high));
  }
});

test("logarithmic ticks are 1, 2, 5, or decades where there is little room", () => {
  assert.deepEqual(logTicks(0.2, 40, 9), [0.2, 0.5, 1, 2, 5, 10, 20]);
  assert.deepEqual(logTicks(0.2, 40, 4), [1, 10]);
  assert.deepEqual(logTicks(1, 1e6, 4), [1, 100, 1e4, 1e6]);
  assert.deepEqual(logTicks(6, 9, 4), [6, 7, 8, 9]);
});

test("given ticks keep their words; others are written with a true minus", () => {
  const ticks = [
    [1, "a pen line"],
    [99, "beyond"],
  ];
  assert.deepEqual(ticksOf({ low: 0, high: 9, ticks }, 5), [[1, "a pen line"]]);
  assert.equal(ticksOf({ low: -1, high: 1 }, 2)[0][1], "−1");
});

test("labels keep their gap and stay inside", () => {
  assert.deepEqual(spread([50, 10, 90], 18, 0, 100), [50, 10, 90]);
  const places = spread([95, 94, 20, 96], 18, 0, 100);
  const order = [...places].sort((a, b) => a - b);
  assert.ok(order.every((place, i) => i === 0 || place - order[i - 1] >= 18));
  assert.ok(places.every((place) => place <= 100 && place >= 0));
  assert.ok(places[1] < places[0] && places[0] < places[3]);
});

test("null, and what is no number, breaks a line", () => {
  const points = [[0, 0], [1, 1], null, [2, 2], [3, Number.NaN], [4, 4], [5, 5]];
  const d = pathOf(points, (place) => place);
  assert.equal(d.match(/M/g).length, 3);
  assert.equal(d.match(/L/g).length, 2);
});

test("handles lie along a stroke at equal lengths of the way", () => {
  assert.deepEqual(alongStroke(SQUARE, 3), SQUARE);
  assert.deepEqual(alongStroke(SQUARE, 5)[1], [1.5, 0]);
  const uneven = [
    [0, 0],
    [0, 0],
    [0.1, 0],
    [0.2, 0],
    [6, 0],
  ];
  const places = alongStroke(uneven, 7).map(([x]) => Math.round(1e9 * x) / 1e9);
  assert.deepEqual(places, [0, 1, 2, 3, 4, 5, 6]);
  assert.deepEqual(alongStroke([[2, 3]], 2), [
    [2, 3],
    [2, 3],
  ]);
});

test("the nearest handle is that on the page, or that of the column", () => {
  const points = [
    [0, 0],
    [8, 100],
  ];
  assert.equal(nearest(points, [7, 1]), 0);
  assert.equal(nearest(points, [7, 1], 0), 1);
});

test("a hand that is too fast for the screen paints the handles that it passes, too", () => {
  const there = painted(ROW, [2, 0], [29, 27]);
  assert.deepEqual(
    there.map(([i]) => i),
    [1, 2, 3],
  );
  assert.deepEqual(there[1], [2, [20, 18]]);
  assert.deepEqual(there[2], [3, [30, 27]]);
  assert.deepEqual(
    painted(ROW, [29, 27], [-5, 0]).map(([i]) => i),
    [2, 1, 0],
  );
  assert.deepEqual(painted(ROW, [11, 5], [12, 7]), [[1, [10, 7]]]);
});

test("equal axes keep what was asked for and give one unit the same length", () => {
  for (const [width, height] of [
    [400, 200],
    [200, 400],
  ]) {
    const [x, y] = equalized(
      { label: "", low: 1, high: 4 },
      { label: "", low: 0, high: 2 },
      width,
      height,
    );
    assert.ok(Math.abs((x.high - x.low) / width - (y.high - y.low) / height) < 1e-12);
    assert.ok(x.low <= 1 && x.high >= 4 && y.low <= 0 && y.high >= 2);
  }
});
