import assert from "node:assert/strict";
import { test } from "node:test";
import * as depth from "../../../labutils/explorers/static/_depth.js";
import * as picture from "../../../labutils/explorers/static/_depth_picture.js";
import { FARTHER, INSIDE, NEARER, NO_SURFACE } from "../../../labutils/explorers/static/_shared.js";
import { readRaw } from "../../../labutils/explorers/static/depth_convention.js";
import { assertNear } from "./_near.mjs";

const [NEAR, FAR] = [0.1, 10];
const STEP = 0.0002;

test("raw 0 is the near plane and raw 1 the far plane, also for values beyond", () => {
  for (const raw of [-1, 0]) assertNear(depth.processDepth(raw, NEAR, FAR), NEAR);
  for (const raw of [1, 2]) assertNear(depth.processDepth(raw, NEAR, FAR), FAR);
});

test("meters become raw values and come back", () => {
  for (const meters of [0.1, 0.5, 3, 9.9]) {
    assertNear(depth.processDepth(depth.metricToRaw(meters, NEAR, FAR), NEAR, FAR), meters);
  }
});

test("a value lies between the two levels that enclose it, which are neighbors", () => {
  for (const value of [0, 0.3, 0.999999, 1]) {
    const [low, high] = depth.integerLevels(value, 16);
    assert.ok(low <= value && value <= high);
    assertNear((high - low) * 65535, 1);
    const [under, over] = depth.floatLevels(value);
    assert.ok(under <= value && value <= over && under < over);
    assert.equal(Math.fround(under), under);
  }
});

test("a step near the far plane is worth more than one near the near plane", () => {
  const gap = (raw) => depth.gapMm(depth.integerLevels(raw, 24), NEAR, FAR);
  assert.ok(gap(0.999) > 1000 * gap(0.001));
});

test("in reversed order the same gap lies at the other end", () => {
  const forward = depth.gapMm([0.2, 0.3], NEAR, FAR);
  assertNear(depth.reversedGapMm([0.7, 0.8], NEAR, FAR), forward, 1e-6);
});

test("a linear reading errs nowhere at the planes, and most in between", () => {
  for (const raw of [0, 1]) assertNear(readRaw(raw, NEAR, FAR).linear_error, 0);
  assert.ok(readRaw(0.5, NEAR, FAR).linear_error > 4);
});

test("halves of a step go up", () => {
  assert.equal(picture.toStep(1.5 * STEP, STEP), 2);
  assert.deepEqual(picture.toSteps([0.01, 10], STEP), [50, 50000]);
});

test("limits of the range belong to it, limits of what is valid do not", () => {
  const kind = (steps) => picture.findKind(steps, [20, 30], [10, 40]);
  assert.deepEqual([10, 11, 19, 20, 30, 31, 39, 40].map(kind), [
    NO_SURFACE,
    NEARER,
    NEARER,
    INSIDE,
    INSIDE,
    FARTHER,
    FARTHER,
    NO_SURFACE,
  ]);
});

test("every pixel is of one kind, and every surface in one bin of each histogram", () => {
  const pixels = Uint16Array.from({ length: 5000 }, (_, i) => (i * 37) % 60000);
  /** @type {Pair[]} */
  const [valid, range] = [
    [50, 50000],
    [5000, 20000],
  ];
  const counts = picture.countSteps(pixels);
  const kinds = picture.countKinds(counts, range, valid);
  const sum = (numbers) => numbers.reduce((a, b) => a + b, 0);
  assert.equal(sum(kinds), pixels.length);
  const surfaces = pixels.length - kinds[NO_SURFACE];
  assert.equal(sum(picture.binMetric(counts, 50, 10, STEP, valid)), surfaces);
  assert.equal(sum(picture.binRaw(counts, 50, STEP, valid, [NEAR, FAR])), surfaces);
});

test("colors reach from the first of the table to the last, and stay there", () => {
  assert.deepEqual(
    [0, 1, 2, 3, 4].map((meters) => picture.findColor(meters, 1, 3)),
    [0, 0, 127, 255, 255],
  );
  assert.equal(picture.findColor(2, 2, 2), 0);
});

test("stripes of what is nearer and of what is farther lean different ways", () => {
  const { findStripe } = picture;
  assert.equal(findStripe(NEARER, 0, 8), findStripe(NEARER, 8, 0));
  assert.equal(findStripe(FARTHER, 0, 0), findStripe(FARTHER, 9, 9));
  assert.notEqual(findStripe(FARTHER, 0, 0), findStripe(FARTHER, 8, 0));
});
