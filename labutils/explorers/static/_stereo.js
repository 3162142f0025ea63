// Two cameras side by side, the right one `baseline` meters along x: disparity and what it is worth.
// Mirrors labutils.stereo. (u, v) is a pixel center; the left camera is the origin.

import { HIDDEN, OUTSIDE, SEEN } from "./_shared.js";

/**
 * How far to the left the right camera sees a point: pixels, for a focal length in pixels.
 * @param {number} depth
 * @param {number} focal
 * @param {number} baseline
 */
export function findDisparity(depth, focal, baseline) {
  return (focal * baseline) / depth;
}

/**
 * Depths that a disparity wrong by up to `error` stands for; the far end is null if there is none.
 * @param {number} disparity
 * @param {number} error
 * @param {number} focal
 * @param {number} baseline
 * @returns {[number, number | null]}
 */
export function findInterval(disparity, error, focal, baseline) {
  const product = focal * baseline;
  return [product / (disparity + error), disparity > error ? product / (disparity - error) : null];
}

/**
 * Largest error of that interval in meters; null if it has no far end.
 * @param {number} depth
 * @param {number} error
 * @param {number} focal
 * @param {number} baseline
 */
export function findLargestError(depth, error, focal, baseline) {
  const left = focal * baseline - depth * error;
  return left > 0 ? (depth * depth * error) / left : null;
}

/**
 * The same for small errors: the first term of its series.
 * @param {number} depth
 * @param {number} error
 * @param {number} focal
 * @param {number} baseline
 */
export function findLinearError(depth, error, focal, baseline) {
  return (depth * depth * error) / (focal * baseline);
}

/**
 * Whether the right camera sees the point of pixel u: not if it lies outside the picture, or if
 * something nearer in the same row of the left picture lands on the same pixel. `row` has depths.
 * @param {number} u
 * @param {ArrayLike<number>} row
 * @param {number} focal
 * @param {number} baseline
 */
export function findRightState(u, row, focal, baseline) {
  const disparities = Float64Array.from(row, (z) => (z ? findDisparity(z, focal, baseline) : 0));
  return findStateAmong(u, disparities);
}

/**
 * The same of a row of disparities, 0 or NaN where there is none.
 * @param {number} u
 * @param {ArrayLike<number>} disparities
 */
export function findStateAmong(u, disparities) {
  const own = disparities[u];
  const place = u - own;
  if (place < -0.5) return OUTSIDE;
  for (let other = u + 1; other < disparities.length; other++) {
    const disparity = disparities[other];
    if (disparity > own + 1 && Math.abs(other - disparity - place) <= 0.5) return HIDDEN;
  }
  return SEEN;
}

/**
 * The point [x, z] from above where the rays through two columns meet; null if they never do.
 * @param {number} uLeft
 * @param {number} uRight
 * @param {Matrix} K
 * @param {number} baseline
 * @returns {Pair | null}
 */
export function meetRays(uLeft, uRight, K, baseline) {
  const disparity = uLeft - uRight;
  if (disparity <= 0) return null;
  const z = (K[0][0] * baseline) / disparity;
  return [((uLeft - K[0][2]) / K[0][0]) * z, z];
}
