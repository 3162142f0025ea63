// RGB to HSV exactly as cv2.cvtColor does for 8 bits: whole-number arithmetic with two tables, so
// that a hue read here is the hue Python reads. Hue 0-179, saturation and value 0-255.

import { HUES } from "./_shared.js";

const SHIFT = 12;
const HALF = 1 << (SHIFT - 1);

// 255 / v and 30 / (max - min) as whole numbers of 1/4096; no entry lies halfway between two, so
// this rounding is also OpenCV's, which prefers even numbers
const PER_VALUE = Int32Array.from({ length: 256 }, (_, v) =>
  v ? Math.round((255 << SHIFT) / v) : 0,
);
const PER_SPREAD = Int32Array.from({ length: 256 }, (_, d) =>
  d ? Math.round((30 << SHIFT) / d) : 0,
);

/**
 * Convert `count` pixels of `channels` bytes each, red first, to a plane of each of H, S and V.
 * @param {ArrayLike<number>} rgb
 * @param {number} count
 * @param {number} channels
 */
export function rgbToHsv(rgb, count, channels = 3) {
  const planes = { h: new Uint8Array(count), s: new Uint8Array(count), v: new Uint8Array(count) };
  for (let i = 0, at = 0; i < count; i++, at += channels) {
    const [r, g, b] = [rgb[at], rgb[at + 1], rgb[at + 2]];
    const value = Math.max(r, g, b);
    const spread = value - Math.min(r, g, b);
    let sixth;
    if (value === r) sixth = g - b;
    else if (value === g) sixth = b - r + 2 * spread;
    else sixth = r - g + 4 * spread;
    const hue = (sixth * PER_SPREAD[spread] + HALF) >> SHIFT;
    planes.h[i] = hue < 0 ? hue + HUES : hue;
    planes.s[i] = (spread * PER_VALUE[value] + HALF) >> SHIFT;
    planes.v[i] = value;
  }
  return planes;
}

/**
 * Whether a hue lies between two limits; where the first is the larger, the range wraps.
 * @param {number} hue
 * @param {number} from
 * @param {number} to
 */
export function isHueInside(hue, from, to) {
  return from <= to ? from <= hue && hue <= to : hue >= from || hue <= to;
}

/**
 * Name the limits, [[h, s, v] low, [h, s, v] high], that keep a color out.
 * @param {Triple} hsv
 * @param {HsvLimits} limits
 */
export function findExcluding([h, s, v], [low, high]) {
  const excluding = [];
  if (!isHueInside(h, low[0], high[0])) excluding.push("hue");
  if (s < low[1] || s > high[1]) excluding.push("saturation");
  if (v < low[2] || v > high[2]) excluding.push("value");
  return excluding;
}

/**
 * Mark the pixels within the limits in `bits`, 32 of a row to a word, the first one lowest. Rows
 * start with a new word.
 * @param {HsvPlanes} planes
 * @param {HsvLimits} limits
 * @param {number} width
 * @param {Uint32Array} bits
 */
export function markRange({ h, s, v }, [low, high], width, bits) {
  /** @param {(value: number) => boolean} test */
  const allowed = (test) => Uint8Array.from({ length: 256 }, (_, one) => (test(one) ? 1 : 0));
  const hues = allowed((one) => isHueInside(one, low[0], high[0]));
  const saturations = allowed((one) => low[1] <= one && one <= high[1]);
  const values = allowed((one) => low[2] <= one && one <= high[2]);
  for (let i = 0, word = 0; i < h.length; ) {
    const rowEnd = i + width;
    while (i < rowEnd) {
      const end = Math.min(i + 32, rowEnd);
      let marked = 0;
      for (let bit = 0; i < end; i++, bit++) {
        marked |= (hues[h[i]] & saturations[s[i]] & values[v[i]]) << bit;
      }
      bits[word++] = marked;
    }
  }
}
