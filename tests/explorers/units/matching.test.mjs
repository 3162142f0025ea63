import assert from "node:assert/strict";
import { test } from "node:test";
import {
  findLimit,
  formatCost,
  roundUp,
  sampleParabola,
} from "../../../labutils/explorers/static/_cost_curve.js";
import * as matching from "../../../labutils/explorers/static/_matching.js";
import { addNoise, makeNoise } from "../../../labutils/explorers/static/_noise.js";
import { SEEN, WINDOWS } from "../../../labutils/explorers/static/_shared.js";
import { findStateAmong } from "../../../labutils/explorers/static/_stereo.js";
import { cut } from "../../../labutils/explorers/static/_windows.js";
import { assertNear } from "./_near.mjs";

const [WIDTH, HEIGHT] = [40, 9];

/** A pair whose left picture is the right one, moved by some columns. */
function makePair(disparity) {
  const right = Uint8ClampedArray.from(makeNoise(WIDTH * HEIGHT, 3), (one) => 128 + one / 8);
  const left = right.map((_, i) => right[i - (i % WIDTH >= disparity ? disparity : 0)]);
  return { left, right, width: WIDTH, height: HEIGHT };
}

test("a window finds by how much the picture was moved, at no cost", () => {
  const curves = matching.findCurves(makePair(6), [20, 4], 12);
  for (const costs of curves.filter((one) => one.length)) {
    assert.equal(matching.findBest(costs), 6);
    assert.equal(costs[6], 0);
  }
});

test("a larger window costs as much as the smaller one and its ring", () => {
  const { left, right } = makePair(6);
  const curves = matching.findCurves({ left, right, width: WIDTH, height: HEIGHT }, [20, 4], 12);
  const expected = [-1, 0, 1].flatMap((y) =>
    [-1, 0, 1].map((x) => (left[(4 + y) * WIDTH + 20 + x] - right[(4 + y) * WIDTH + 18 + x]) ** 2),
  );
  assert.equal(
    curves[0][2],
    expected.reduce((sum, one) => sum + one),
  );
  assert.ok(curves[0].every((cost, d) => cost <= curves[1][d]));
});

test("a curve ends where its window would leave the right picture", () => {
  const lengths = matching.findCurves(makePair(2), [5, 4], 12).map((costs) => costs.length);
  // windows of 3, 5, 7, 9 have 5, 4, 3, 2 candidates; wider ones are higher than the picture
  assert.deepEqual(
    lengths,
    WINDOWS.map((_, i) => (i < 4 ? 5 - i : 0)),
  );
});

test("without a pixel there is no curve and no match", () => {
  assert.ok(matching.findCurves(makePair(2), [], 12).every((costs) => !costs.length));
  const scene = { ...makePair(2), product: 40, readRow: () => [] };
  const values = matching.describeMatch(scene, [], 9, 12);
  assert.equal(values.disparity, null);
  assert.equal(values.right_windows, null);
});

test("of equal costs the smallest disparity wins", () => {
  assert.equal(matching.findBest([3, 1, 2, 1]), 1);
  assert.equal(matching.findBest([]), -1);
});

test("the parabola goes through all three costs, and its lowest point is the sub-pixel match", () => {
  const costs = [50, 12, 3, 9, 60];
  const points = new Map(sampleParabola(costs, 2).map(([d, cost]) => [d.toFixed(1), cost]));
  assertNear(points.get("2.0"), 3);
  // x = -1 and 1 lie between two samples: the second difference is the same everywhere
  const [a, b, c] = ["1.8", "2.0", "2.2"].map((d) => points.get(d));
  assertNear((a - 2 * b + c) / 0.04, 12 - 2 * 3 + 9);
  assertNear(matching.refine(costs, 2), 2 + (12 - 9) / (2 * (12 - 6 + 9)));
  assert.deepEqual(sampleParabola(costs, 0), []);
});

test("an end of the curve and a flat valley are not refined", () => {
  assert.equal(matching.refine([1, 2, 3], 0), 0);
  assert.equal(matching.refine([2, 2, 2], 1), 1);
});

test("the runner-up is another valley", () => {
  assert.equal(matching.findRunnerUp([9, 1, 2, 3, 4], 1), null);
  assert.equal(matching.findRunnerUp([9, 1, 4, 2, 5, 3, 6], 1), 3);
});

test("a row of disparities tells what the right camera sees, without a detour by depth", () => {
  const row = new Float64Array(60).fill(5);
  row[50] = Number.NaN;
  assert.equal(findStateAmong(30, row), SEEN);
});

test("no noise changes nothing, and noise stays within eight bits", () => {
  const gray = Uint8Array.of(0, 100, 255);
  const out = new Uint8ClampedArray(3);
  addNoise(gray, Int16Array.of(510, 510, 510), 0, out);
  assert.deepEqual([...out], [0, 100, 255]);
  addNoise(gray, Int16Array.of(-510, 510, 510), 20, out);
  assert.deepEqual([...out], [0, 169, 255]);
});

test("a window that is not wholly inside cannot be shown", () => {
  const { left } = makePair(0);
  const size = { width: WIDTH, height: HEIGHT };
  assert.equal(cut(left, size, [0, 4], 3), null);
  assert.equal(cut(left, size, [5, 8], 3), null);
  assert.deepEqual([...cut(left, size, [1, 1], 3)].slice(0, 3), [...left.slice(0, 3)]);
});

test("the plot holds every valley, and lets what is far too different leave it", () => {
  assert.equal(findLimit([], 9), 20);
  assert.equal(findLimit([90, 180], 9), 20);
  assert.equal(findLimit([1000, 9, 900, 990], 9), 150);
  assert.equal(findLimit([9000, 9, 900, 720, 810], 9), 200);
});

test("limits of the curve are round", () => {
  assertNear([1, 1.2, 23, 95, 100, 1300].map(roundUp), [1, 1.5, 30, 100, 100, 1500]);
});

test("a cost is told with as many digits as it deserves", () => {
  assert.deepEqual([0, 3.14, 41.6, 1234].map(formatCost), ["0.0", "3.1", "42", "1,234"]);
});
