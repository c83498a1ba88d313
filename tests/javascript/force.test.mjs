import assert from "node:assert/strict";
import { test } from "node:test";
import { feelOf, feltAt } from "../../dmp_teach/views/scene/force.js";

const CURVE = [
  [0, 0, 10, 20],
  [1, 2, 12, 20],
];

test("force and place are even between two points, and those of the ends beyond them", () => {
  assert.deepEqual(feltAt(CURVE, 0.25), [0.25, 0.5, 10.5, 20]);
  assert.deepEqual(feltAt(CURVE, -1), CURVE[0]);
  assert.deepEqual(feltAt(CURVE, 2), CURVE[1]);
});

test("every force feels like something, and in the air nothing is judged", () => {
  assert.deepEqual(feelOf(0.25, true), ["As heavy as a strawberry", "good pressing"]);
  assert.deepEqual(feelOf(50, true), ["As heavy as a bucket of water", "much too hard"]);
  assert.deepEqual(feelOf(0, false), ["The pen is in the air.", undefined]);
  assert.deepEqual(feelOf(0, true), ["The pen does not reach the paper."]);
});
