import assert from "node:assert/strict";
import { test } from "node:test";
import * as color from "../../../labutils/explorers/static/_color.js";
import * as morphology from "../../../labutils/explorers/static/_morphology.js";
import { makeRegionFinder } from "../../../labutils/explorers/static/_regions.js";
import { makeSegmenter } from "../../../labutils/explorers/static/_segment.js";

/** @type {HsvLimits} */
const ALL = [
  [0, 0, 0],
  [179, 255, 255],
];

/** Bits of a mask drawn in text: a row each, # is set. */
function toBits(rows) {
  const words = morphology.countWords(rows[0].length);
  const bits = new Uint32Array(words * rows.length);
  for (const [y, row] of rows.entries()) {
    for (const [x, mark] of [...row].entries()) {
      if (mark === "#") bits[y * words + (x >> 5)] |= 1 << (x & 31);
    }
  }
  return bits;
}

test("pure colors lie a third of the circle apart; gray has neither hue nor saturation", () => {
  const { h, s, v } = color.rgbToHsv([255, 0, 0, 0, 255, 0, 0, 0, 255, 90, 90, 90], 4);
  assert.deepEqual([...h], [0, 60, 120, 0]);
  assert.deepEqual([...s], [255, 255, 255, 0]);
  assert.deepEqual([...v], [255, 255, 255, 90]);
});

test("a fourth channel is passed over", () => {
  const { h } = color.rgbToHsv([255, 0, 0, 7, 0, 255, 0, 7], 2, 4);
  assert.deepEqual([...h], [0, 60]);
});

test("where the first limit of the hue is the larger, the range goes through 0", () => {
  const inside = (hue) => color.isHueInside(hue, 170, 6);
  assert.deepEqual([169, 170, 179, 0, 6, 7].map(inside), [false, true, true, true, true, false]);
});

test("every limit that keeps a color out is named", () => {
  /** @type {HsvLimits} */
  const limits = [
    [10, 20, 30],
    [40, 50, 60],
  ];
  assert.deepEqual(color.findExcluding([5, 5, 5], limits), ["hue", "saturation", "value"]);
  assert.deepEqual(color.findExcluding([10, 50, 60], limits), []);
});

test("a row begins with a new word, and what lies behind it stays empty", () => {
  const planes = color.rgbToHsv(new Uint8Array(3 * 33 * 2), 66);
  const bits = new Uint32Array(morphology.countWords(33) * 2);
  color.markRange(planes, ALL, 33, bits);
  assert.deepEqual([...bits], [0xffffffff, 1, 0xffffffff, 1]);
});

test("opening removes what the square does not fit into, closing fills what it spans", () => {
  const alone = toBits(["......", "..#...", "......"]);
  morphology.makeMorphology(6, 3).open(alone, 1);
  assert.deepEqual(alone, toBits(["......", "......", "......"]));
  const holed = toBits(["######", "##.###", "######"]);
  morphology.makeMorphology(6, 3).close(holed, 1);
  assert.deepEqual(holed, toBits(["######", "######", "######"]));
});

test("the border of the picture removes nothing", () => {
  const full = toBits(["###", "###"]);
  morphology.makeMorphology(3, 2).open(full, 6);
  assert.deepEqual(full, toBits(["###", "###"]));
});

test("the centroid is that of the largest region, and lines have none", () => {
  const find = (rows) => {
    const finder = makeRegionFinder(rows[0].length, rows.length);
    finder.load(toBits(rows));
    return finder.findCentroid();
  };
  assert.deepEqual(find(["##....", "##.###", "...###", "...###"]), [4, 2]);
  assert.equal(find(["......", "######"]), null);
  assert.equal(find(["......"]), null);
});

test("a picked pixel outside the picture is none", () => {
  const data = Uint8Array.of(255, 0, 0, 0, 0, 255);
  const segmenter = makeSegmenter({ width: 2, height: 1, channels: 3, data });
  segmenter.segment(ALL, 0, 0);
  assert.equal(segmenter.describePixel([2, 0], ALL).pixel_hsv, null);
  assert.equal(segmenter.describePixel([], ALL).pixel_rgb, null);
  assert.deepEqual(segmenter.describePixel([1, 0], ALL).pixel_rgb, [0, 0, 255]);
});
