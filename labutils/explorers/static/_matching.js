// Match the window around one pixel: costs of all disparities, for every window size; the minimum,
// below a pixel; the runner-up. Mirrors labutils.stereo_matching.

import { GOOD_PX, LARGE_WINDOW, SMALL_WINDOW, WINDOWS } from "./_shared.js";
import { findStateAmong } from "./_stereo.js";

const MOST = WINDOWS[WINDOWS.length - 1] >> 1;

/**
 * Sums of squared differences by disparity, one list for each of WINDOWS. A list ends where its
 * window would leave the right picture, and is empty where it leaves the left one.
 * @param {GrayPair} pair
 * @param {Pixel} pixel
 * @param {number} search how many disparities are tried
 */
export function findCurves({ left, right, width, height }, [u, v], search) {
  /** @type {number[][]} */
  const curves = WINDOWS.map(() => []);
  if (u === undefined) return curves;
  const inside = Math.min(MOST, u, v, width - 1 - u, height - 1 - v);
  const center = v * width + u;
  for (let d = 0; d < search && d <= u; d++) {
    const last = Math.min(inside, u - d);
    let sum = 0;
    for (let ring = 0; ring <= last; ring++) {
      sum += sumRing(left, right, center, d, ring, width);
      if (ring) curves[ring - 1].push(sum);
    }
  }
  return curves;
}

/**
 * Sum the squared differences of the pixels that a window has more than the next smaller one.
 * @param {ArrayLike<number>} left
 * @param {ArrayLike<number>} right
 * @param {number} center
 * @param {number} disparity
 * @param {number} ring
 * @param {number} width
 */
function sumRing(left, right, center, disparity, ring, width) {
  let sum = 0;
  const add = (/** @type {number} */ at) => {
    const off = left[at] - right[at - disparity];
    sum += off * off;
  };
  if (ring === 0) add(center);
  for (let i = -ring; i < ring; i++) {
    // one side of the square each, without its last corner
    add(center - ring * width + i);
    add(center + i * width + ring);
    add(center + ring * width - i);
    add(center - i * width - ring);
  }
  return sum;
}

/**
 * The disparity of the smallest cost; of equal ones the smallest. -1 where there is none.
 * @param {number[]} costs
 */
export function findBest(costs) {
  let best = costs.length ? 0 : -1;
  for (let d = 1; d < costs.length; d++) if (costs[d] < costs[best]) best = d;
  return best;
}

/**
 * Move a disparity to the lowest point of the parabola through its cost and its neighbors'.
 * @param {number[]} costs
 * @param {number} disparity
 */
export function refine(costs, disparity) {
  if (disparity <= 0 || disparity >= costs.length - 1) return disparity;
  const [before, here, after] = costs.slice(disparity - 1, disparity + 2);
  const bend = before - 2 * here + after;
  return bend > 0 ? disparity + (before - after) / (2 * bend) : disparity;
}

/**
 * The lowest of the other valleys of the curve; null where there is no other.
 * @param {number[]} costs
 * @param {number} best
 */
export function findRunnerUp(costs, best) {
  let found = null;
  for (let d = 1; d < costs.length - 1; d++) {
    const isValley = costs[d] < costs[d - 1] && costs[d] <= costs[d + 1];
    if (!isValley || Math.abs(d - best) <= 1) continue;
    if (found === null || costs[d] < costs[found]) found = d;
  }
  return found;
}

/**
 * What a window finds at a pixel; the same as MatchingView.compute in Python.
 * @param {MatchScene} scene
 * @param {Pixel} pixel
 * @param {number} window
 * @param {number} search
 * @returns {MatchValues}
 */
export function describeMatch(scene, pixel, window, search) {
  const row = pixel.length ? scene.readRow(pixel[1]) : [];
  const truth = row[pixel[0]] > 0 ? row[pixel[0]] : null;
  const curves = findCurves(scene, pixel, search);
  const costs = curves[WINDOWS.indexOf(window)];
  const errors = curves.map((one) =>
    truth === null || !one.length ? null : Math.abs(refine(one, findBest(one)) - truth),
  );
  const rightWindows = errors.filter((one) => one !== null && one <= GOOD_PX).length;
  return {
    costs,
    ...describeMinimum(costs, truth, window, scene.product),
    truth,
    true_depth: truth === null ? null : scene.product / truth,
    right: truth === null ? null : findStateAmong(pixel[0], row),
    errors_px: errors,
    small_window_px: errors[WINDOWS.indexOf(SMALL_WINDOW)],
    large_window_px: errors[WINDOWS.indexOf(LARGE_WINDOW)],
    right_windows: truth === null ? null : rightWindows,
  };
}

/**
 * @param {number[]} costs
 * @param {number | null} truth
 * @param {number} window
 * @param {number} product focal length times baseline
 * @returns {Minimum | Nothing<Minimum>}
 */
function describeMinimum(costs, truth, window, product) {
  const best = findBest(costs);
  if (best < 0) {
    const nothing = { disparity: null, cost: null, subpixel: null, depth: null };
    return { ...nothing, second: null, ratio: null, error_px: null, depth_error_mm: null };
  }
  const subpixel = refine(costs, best);
  const depth = subpixel ? product / subpixel : null;
  const second = findRunnerUp(costs, best);
  return {
    disparity: best,
    cost: costs[best] / window ** 2,
    subpixel,
    depth,
    second,
    ratio: second === null ? null : costs[best] / Math.max(costs[second], 1),
    error_px: truth === null ? null : subpixel - truth,
    depth_error_mm: truth === null || depth === null ? null : 1000 * (depth - product / truth),
  };
}
