// From depth to points, as labutils.pointcloud does. Nothing here knows of a screen.

import { pixelToPoint } from "./_camera.js";
import { movePoint } from "./_orbit.js";

/**
 * K of an assumed field of view, and the ratio by which it makes the cloud too wide.
 * @param {Matrix} trueK
 * @param {number} trueFovDegrees
 * @param {number} fovDegrees
 */
export function assumeIntrinsics(trueK, trueFovDegrees, fovDegrees) {
  /** @param {number} degrees */
  const half = (degrees) => Math.tan((degrees * Math.PI) / 360);
  const stretch = half(fovDegrees) / half(trueFovDegrees);
  const K = trueK.map((row) => [...row]);
  K[0][0] /= stretch;
  K[1][1] /= stretch;
  return { K, stretch };
}

/**
 * Depth of a pixel in meters, rounded to float32 as labutils does; 0 where nothing is seen.
 * @param {Pick<Cloud, "steps" | "width" | "depthStep">} cloud
 * @param {number} u
 * @param {number} v
 */
export function readDepth({ steps, width, depthStep }, u, v) {
  return Math.fround(steps[v * width + u] * depthStep);
}

/**
 * Is this depth a surface, closer than `far`?
 * @param {Pick<Cloud, "minDepth">} cloud
 * @param {number} depth
 * @param {number} far
 */
export function isValid({ minDepth }, depth, far) {
  return depth > Math.fround(minDepth) && depth < Math.fround(far);
}

/**
 * Make the function that counts the points closer than `far`, without looking at all of them.
 * @param {CountedCloud} cloud
 */
export function makeCounter(cloud) {
  const counts = new Uint32Array(65536);
  for (const step of cloud.steps) counts[step]++;
  let [asked, sum] = [NaN, 0];
  return (/** @type {number} */ far) => {
    if (far === asked) return sum;
    [asked, sum] = [far, 0];
    for (let step = 0; step < counts.length; step++) {
      if (counts[step] && isValid(cloud, Math.fround(step * cloud.depthStep), far))
        sum += counts[step];
    }
    return sum;
  };
}

/**
 * The point of a pixel in the camera frame and in the world; null where there is none.
 * @param {Cloud} cloud
 * @param {Pixel} pixel
 * @param {Matrix} K
 * @param {number} far
 * @returns {FoundPoint}
 */
export function findPoint(cloud, pixel, K, far) {
  const nothing = { point_camera: null, point_world: null };
  if (!pixel.length) return nothing;
  const [u, v] = pixel;
  const depth = readDepth(cloud, u, v);
  if (!isValid(cloud, depth, far)) return nothing;
  const point = pixelToPoint(u, v, depth, K);
  return {
    point_camera: point,
    point_world: cloud.worldFromCamera && movePoint(cloud.worldFromCamera, point),
  };
}

/**
 * The corners of a face: its pixels as points of the camera frame.
 * @param {Cloud} cloud
 * @param {Pair[]} pixels
 * @param {Matrix} K
 */
export function findCorners(cloud, pixels, K) {
  return pixels.map(([u, v]) => pixelToPoint(u, v, readDepth(cloud, u, v), K));
}

/**
 * The angle in which two faces meet, in degrees, on the side that the camera sees.
 * @param {Cloud} cloud
 * @param {Matrix} K
 */
export function measureAngle(cloud, K) {
  if (!cloud.faces.length) return null;
  const [one, two] = cloud.faces.map(([, pixels]) => findNormal(findCorners(cloud, pixels, K)));
  const cosine = one[0] * two[0] + one[1] * two[1] + one[2] * two[2];
  return 180 - (Math.acos(Math.min(1, Math.max(-1, cosine))) * 180) / Math.PI;
}

/**
 * The direction in which a face looks: toward the camera.
 * @param {Triple[]} corners
 * @returns {number[]}
 */
function findNormal([first, second, third]) {
  const [a, b] = [second, third].map((point) => point.map((value, i) => value - first[i]));
  const normal = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const away = normal[0] * first[0] + normal[1] * first[1] + normal[2] * first[2];
  const scale = (away > 0 ? -1 : 1) / Math.hypot(...normal);
  return normal.map((value) => value * scale);
}

/**
 * Fill `out` with the color of every pixel: 0 its own, 1 by depth, 2 by height.
 * @param {Cloud} cloud
 * @param {Matrix} K
 * @param {number} mode
 * @param {Uint32Array} out
 */
export function colorPoints(cloud, K, mode, out) {
  const { width, height, steps, depthStep, palette32, orbitFromCamera: T } = cloud;
  if (mode === 0) {
    out.set(cloud.rgba32);
    return;
  }
  const [low, high] = mode === 1 ? cloud.depthLimits : cloud.heightLimits;
  const scale = 256 / (high - low);
  for (let v = 0, i = 0; v < height; v++) {
    const y = (v - K[1][2]) / K[1][1];
    for (let u = 0; u < width; u++, i++) {
      const z = steps[i] * depthStep;
      const x = (u - K[0][2]) / K[0][0];
      // y points down in the frame one orbits in
      const value = mode === 1 ? z : -z * (T[4] * x + T[5] * y + T[6]) - T[7];
      out[i] = palette32[Math.max(0, Math.min(255, Math.floor((value - low) * scale)))];
    }
  }
}
