import assert from "node:assert/strict";
import { test } from "node:test";
import { findBin } from "../../../labutils/explorers/static/_bins.js";
import { findBinStarts } from "../../../labutils/explorers/static/_depth_picture.js";
import { paintShade, toPixel } from "../../../labutils/explorers/static/_hover.js";
import { warpRows } from "../../../labutils/explorers/static/_right_eye.js";

test("a pointer on a picture shown smaller names the pixel below it, and keeps inside", () => {
  const box = { left: 100, top: 50, width: 200, height: 100 };
  const canvas = { width: 640, height: 480, getBoundingClientRect: () => box };
  const at = (clientX, clientY) => toPixel(canvas, { clientX, clientY });
  assert.deepEqual(at(100, 50), [0, 0]);
  assert.deepEqual(at(200, 100), [320, 240]);
  assert.deepEqual(at(103.2, 50), [10, 0]);
  assert.deepEqual(at(300, 150), [639, 479]);
  assert.deepEqual(at(99, 200), [0, 479]);
});

test("a place beside the bars of a plot is none of them", () => {
  const area = { left: 40, right: 140 };
  assert.deepEqual(
    [39, 40, 89.9, 90, 139.9, 140].map((x) => findBin(x, 10, area)),
    [null, 0, 4, 5, 9, null],
  );
});

test("the bins of depths begin where counting puts them, also where bins are empty", () => {
  const toBin = (steps) => Math.floor((steps * 5) / 100);
  const starts = findBinStarts(5, toBin, [30, 90]);
  assert.deepEqual(starts, [31, 31, 40, 60, 80, 90]);
  for (let steps = 31; steps < 90; steps++) {
    const bin = toBin(steps);
    assert.ok(starts[bin] <= steps && steps < starts[bin + 1]);
  }
});

test("pixels outside the chosen depths are shaded, the others are left as they are", () => {
  const out = new Uint32Array(5).fill(7);
  paintShade([9, 10, 11, 12, 0], [10, 12], out);
  assert.deepEqual(
    [...out].map((one) => one !== 0),
    [true, false, false, true, true],
  );
});

test("the right eye sees a near point farther left, over what it covers, and knows no more", () => {
  // focal 1, baseline 4: depth 2 is two pixels of disparity, depth 4 one
  const left = {
    width: 6,
    colors: Uint32Array.from([1, 2, 3, 4, 5, 6]),
    depths: [4, 4, 4, 2, 2, 4],
  };
  const out = new Uint32Array(6);
  warpRows(left, [0, 1], 1, 4, out);
  // 2 is covered by 4, 3 by 5; between 5 and 6 there is what the left eye did not see
  assert.deepEqual([...out], [2, 4, 5, 0, 6, 0]);
});

test("what has no depth is infinitely far: the right eye sees it in the same column", () => {
  const left = { width: 4, colors: Uint32Array.from([1, 2, 3, 4]), depths: [0, 0, 0, 1] };
  const out = new Uint32Array(4);
  warpRows(left, [0, 1], 1, 2, out);
  assert.deepEqual([...out], [1, 4, 3, 0]);
});

test("a point between two columns of the right eye fills both, so that faces have no gaps", () => {
  const left = { width: 5, colors: new Uint32Array(5).fill(9), depths: [4, 3.5, 3, 2.6, 2.3] };
  const out = new Uint32Array(5);
  warpRows(left, [0, 1], 1, 4, out);
  const seen = [...out];
  assert.equal(seen.slice(0, seen.lastIndexOf(9)).includes(0), false);
});
