import assert from "node:assert/strict";
import { test } from "node:test";
import { findShapes, formatInterval } from "../../../labutils/explorers/static/_rays.js";
import { HIDDEN, OUTSIDE, SEEN } from "../../../labutils/explorers/static/_shared.js";
import * as stereo from "../../../labutils/explorers/static/_stereo.js";
import { describePair } from "../../../labutils/explorers/static/stereo.js";
import { assertNear } from "./_near.mjs";

const [FOCAL, BASELINE] = [500, 0.1];
const K = [
  [FOCAL, 0, 320],
  [0, FOCAL, 240],
  [0, 0, 1],
];

test("twice as far is half the disparity", () => {
  assertNear(stereo.findDisparity(1, FOCAL, BASELINE), 50);
  assertNear(stereo.findDisparity(2, FOCAL, BASELINE), 25);
});

test("an error as large as the disparity leaves the far end open", () => {
  assertNear(stereo.findInterval(50, 10, FOCAL, BASELINE), [50 / 60, 50 / 40]);
  assert.equal(stereo.findInterval(0.5, 0.5, FOCAL, BASELINE)[1], null);
  assert.equal(stereo.findLargestError(100, 0.5, FOCAL, BASELINE), null);
});

test("the largest error is the distance to the far end, and little errors grow with the square", () => {
  const [, far] = stereo.findInterval(25, 0.5, FOCAL, BASELINE);
  assertNear(stereo.findLargestError(2, 0.5, FOCAL, BASELINE), far - 2);
  const [one, two] = [1, 2].map((z) => stereo.findLinearError(z, 0.5, FOCAL, BASELINE));
  assertNear(two / one, 4);
});

test("the right eye misses what falls out of its picture, and what something nearer hides", () => {
  const row = new Float64Array(200).fill(2); // disparity 25
  assert.equal(stereo.findRightState(24, row, FOCAL, BASELINE), OUTSIDE);
  assert.equal(stereo.findRightState(100, row, FOCAL, BASELINE), SEEN);
  row[125] = 1; // disparity 50: lands where pixel 100 lands
  assert.equal(stereo.findRightState(100, row, FOCAL, BASELINE), HIDDEN);
});

test("rays through two columns meet at the depth of their disparity", () => {
  assertNear(stereo.meetRays(370, 320, K, BASELINE), [0.1, 1]);
  assert.equal(stereo.meetRays(320, 320, K, BASELINE), null);
});

test("without a surface every value is empty", () => {
  for (const u of [undefined, 1]) {
    const values = describePair(u, [1, 0], FOCAL, BASELINE, 0.5);
    assert.deepEqual(new Set(Object.values(values)), new Set([null]));
  }
});

test("the diamond has the nearest and the farthest depth as its tips", () => {
  const { wedges, diamond } = findShapes([350, 300], K, BASELINE, 1, 5);
  const depths = diamond.map(([, z]) => z);
  const [near, far] = stereo.findInterval(50, 1, FOCAL, BASELINE);
  assertNear([Math.min(...depths), Math.max(...depths)], [near, far]);
  assertNear(wedges[1][0], [BASELINE, 0]);
});

test("where the rays never meet, the diamond ends at the reach", () => {
  const { diamond } = findShapes([320.2, 320], K, BASELINE, 1, 500);
  assert.equal(Math.max(...diamond.map(([, z]) => z)), 500);
});

test("an interval is told with its end, without one, or not at all", () => {
  assert.equal(formatInterval(1, 2), "1.000 to 2.000 m");
  assert.equal(formatInterval(1, null), "1.000 m or more");
  assert.equal(formatInterval(null, null), "none");
});
