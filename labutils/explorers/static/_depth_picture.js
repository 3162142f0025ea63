// Paint a depth image and count its pixels. Depth comes in whole steps, as decoded from the PNG.
// Mirrors labutils.explorers._depth_picture.

import { metricToRaw } from "./_depth.js";
import { FARTHER, INSIDE, NEARER, NO_SURFACE, STRIPES } from "./_shared.js";

export const LEVELS = 65536;
const BLACK = 0xff000000;

/**
 * The step that holds a number of meters.
 * @param {number} meters
 * @param {number} step
 */
export function toStep(meters, step) {
  return Math.floor(meters / step + 0.5);
}

/**
 * The steps that hold two limits in meters.
 * @param {Pair} limits
 * @param {number} step
 * @returns {Pair}
 */
export function toSteps([low, high], step) {
  return [toStep(low, step), toStep(high, step)];
}

/**
 * Which kind of pixel holds this many steps; `valid` and `range` are limits in steps.
 * @param {number} steps
 * @param {Pair} range
 * @param {Pair} valid
 */
export function findKind(steps, range, valid) {
  if (!(steps > valid[0] && steps < valid[1])) return NO_SURFACE;
  if (steps < range[0]) return NEARER;
  return steps > range[1] ? FARTHER : INSIDE;
}

/**
 * How many pixels hold each number of steps.
 * @param {ArrayLike<number> & Iterable<number>} pixels
 */
export function countSteps(pixels) {
  const counts = new Uint32Array(LEVELS);
  for (const steps of pixels) counts[steps] += 1;
  return counts;
}

/**
 * How many pixels are of each kind.
 * @param {ArrayLike<number>} counts
 * @param {Pair} range
 * @param {Pair} valid
 */
export function countKinds(counts, range, valid) {
  const kinds = [0, 0, 0, 0];
  for (let steps = 0; steps < LEVELS; steps++) {
    if (counts[steps]) kinds[findKind(steps, range, valid)] += counts[steps];
  }
  return kinds;
}

/**
 * Counts per bin of depth, from 0 to `upper` meters: surfaces only.
 * @param {ArrayLike<number>} counts
 * @param {number} bins
 * @param {number} upper
 * @param {number} step
 * @param {Pair} valid
 * @returns {number[]}
 */
export function binMetric(counts, bins, upper, step, valid) {
  const end = toStep(upper, step);
  const found = new Array(bins).fill(0);
  for (let steps = valid[0] + 1; steps < Math.min(valid[1], end); steps++) {
    found[Math.floor((steps * bins) / end)] += counts[steps];
  }
  return found;
}

/**
 * Counts per bin of raw value, from 0 to 1: surfaces only.
 * @param {ArrayLike<number>} counts
 * @param {number} bins
 * @param {number} step
 * @param {Pair} valid
 * @param {Pair} clip
 * @returns {number[]}
 */
export function binRaw(counts, bins, step, valid, [near, far]) {
  const found = new Array(bins).fill(0);
  for (let steps = valid[0] + 1; steps < valid[1]; steps++) {
    if (!counts[steps]) continue;
    const raw = metricToRaw(steps * step, near, far);
    found[Math.min(bins - 1, Math.floor(raw * bins))] += counts[steps];
  }
  return found;
}

/**
 * The first step of every bin, and behind them the end of the last; `toBin` never falls.
 * @param {number} bins
 * @param {(steps: number) => number} toBin
 * @param {Pair} valid
 * @returns {number[]}
 */
export function findBinStarts(bins, toBin, valid) {
  const starts = [];
  for (let steps = valid[0] + 1; steps < valid[1] && starts.length <= bins; steps++) {
    const bin = toBin(steps);
    while (starts.length <= Math.min(bin, bins)) starts.push(steps);
  }
  while (starts.length <= bins) starts.push(valid[1]);
  return starts;
}

/**
 * Turn 256 RGB colors, starting at byte `from`, into what `paintDepth` writes.
 * @param {ArrayLike<number>} bytes
 * @param {number} from
 */
export function readTable(bytes, from) {
  const colors = new Uint32Array(256);
  for (let i = 0, at = from; i < 256; i++, at += 3) {
    colors[i] = BLACK | bytes[at] | (bytes[at + 1] << 8) | (bytes[at + 2] << 16);
  }
  return colors;
}

/**
 * Place in the color table, 0 to 255, as in labutils.visualize_depth when `near` is 0.
 * @param {number} meters
 * @param {number} near
 * @param {number} far
 */
export function findColor(meters, near, far) {
  const share = far > near ? (meters - near) / (far - near) : 0;
  return Math.floor(Math.min(1, Math.max(0, share)) * 255);
}

/**
 * Color of a stripe: kind of pixel, then its column and row. Each kind leans its own way, so they
 * differ without color as well.
 * @param {number} kind
 * @param {number} u
 * @param {number} v
 */
export function findStripe(kind, u, v) {
  const across = kind === NEARER ? u + v : u - v;
  return STRIPES[kind][(across >> 3) & 1];
}

/**
 * Paint every pixel into `out`, one 32-bit color each; `palette` is room for `LEVELS` colors.
 * @param {ArrayLike<number>} pixels
 * @param {number} width
 * @param {DepthLook} look
 * @param {Uint32Array} palette
 * @param {Uint32Array} out
 */
export function paintDepth(pixels, width, { table, range, rangeSteps, valid, step }, palette, out) {
  const [low, high] = rangeSteps;
  const [first, last] = [Math.max(low, valid[0] + 1), Math.min(high, valid[1] - 1)];
  for (let steps = first; steps <= last; steps++) {
    palette[steps] = table[findColor(steps * step, range[0], range[1])];
  }
  for (let i = 0, u = 0, v = 0; i < pixels.length; i++) {
    const steps = pixels[i];
    if (steps <= valid[0] || steps >= valid[1]) out[i] = BLACK;
    else if (steps < low) out[i] = STRIPES[NEARER][((u + v) >> 3) & 1];
    else if (steps > high) out[i] = STRIPES[FARTHER][((u - v) >> 3) & 1];
    else out[i] = palette[steps];
    if (++u === width) {
      u = 0;
      v += 1;
    }
  }
}
