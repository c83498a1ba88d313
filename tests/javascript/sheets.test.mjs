import assert from "node:assert/strict";
import { test } from "node:test";
import { momentOf, stillsOf } from "../../dmp_teach/classroom/panels/sheets.js";

const STROKES = [
  [
    [0, 0],
    [2, 0],
  ],
  [
    [5, 5],
    [5, 7],
  ],
];
const TIMES = [
  [0, 1],
  [2, 3],
];

test("half of a stroke is written half of the way through its time", () => {
  const { line, pen, rest } = momentOf(STROKES, TIMES, 0.5);
  assert.deepEqual(line, [
    [
      [0, 0],
      [1, 0],
    ],
  ]);
  assert.deepEqual(pen, { at: [1, 0], down: true });
  assert.equal(rest, STROKES);
});

test("between two strokes the first is whole, at the end both are", () => {
  assert.deepEqual(momentOf(STROKES, TIMES, 1.5).line, STROKES.slice(0, 1));
  assert.deepEqual(momentOf(STROKES, TIMES, 3).line, STROKES);
});

test("a still is the end of each stroke, or a third of the only one", () => {
  assert.deepEqual(stillsOf(TIMES), [1, 3]);
  assert.deepEqual(stillsOf([[0, 3]]), [1, 2, 3]);
});
