import assert from "node:assert/strict";
import { test } from "node:test";
import { affinePoints, unpack } from "../../dmp_teach/classroom/panels/affine.js";

const BASE = [0, 1, 2, 3];
const TERMS = { goal: [0, 0, 10, 0], weight: [0, 1, 0, 2] };

test("points are the base and every term as often as its value says", () => {
  assert.deepEqual(affinePoints(BASE, TERMS, { goal: 0.5, weight: -1, unknown: 7 }), [
    [0, 0],
    [7, 1],
  ]);
});

test("without values the base is seen, and nothing is changed by drawing", () => {
  affinePoints(BASE, TERMS, { goal: 1 });
  assert.deepEqual(affinePoints(BASE, TERMS, {}), [
    [0, 1],
    [2, 3],
  ]);
});

test("bytes that begin anywhere in a message are numbers", () => {
  const message = new Uint8Array(3 + 16);
  message.set(new Uint8Array(new Float64Array([0.1, -7]).buffer), 3);
  assert.deepEqual([...unpack(new DataView(message.buffer, 3))], [0.1, -7]);
});
