import assert from "node:assert/strict";
import { test } from "node:test";
import { chooseTicks, makeScale, toPath } from "../../../labutils/explorers/static/_plot.js";
import { decodePng } from "../../../labutils/explorers/static/_png.js";
import { assertNear } from "./_near.mjs";

test("a scale takes its limits to its places, also downward", () => {
  const scale = makeScale([1, 3], [100, 0]);
  assertNear([1, 2, 3].map(scale), [100, 50, 0]);
});

test("a logarithmic scale gives every power of ten the same room", () => {
  const scale = makeScale([0.1, 1000], [0, 4], true);
  assertNear([0.1, 1, 10, 1000].map(scale), [0, 1, 2, 4]);
});

test("ticks are round and lie within the limits", () => {
  assert.deepEqual(chooseTicks([0, 10]), [0, 2, 4, 6, 8, 10]);
  assert.deepEqual(chooseTicks([0, 0.3], 4), [0, 0.1, 0.2, 0.3]);
  assert.deepEqual(chooseTicks([-1, 1], 4), [-1, -0.5, 0, 0.5, 1]);
  assert.deepEqual(chooseTicks([0.1, 100], 5, true), [0.1, 1, 10, 100]);
});

test("a path begins with a move and goes on with lines", () => {
  assert.equal(
    toPath([
      [1, 2],
      [3.456, 4],
    ]),
    "M1.00 2.00L3.46 4.00",
  );
});

test("bytes that are no PNG are refused", async () => {
  await assert.rejects(decodePng(new Uint8Array(50)), /this is no PNG/);
});
