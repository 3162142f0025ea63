// Window depth and meters, as in labutils.depth_processing; and what one step of a buffer is worth.

/**
 * Meters of a raw value: 0 is the near plane, 1 the far plane, hyperbolic in between.
 * @param {number} raw
 * @param {number} near
 * @param {number} far
 */
export function processDepth(raw, near, far) {
  const inside = Math.min(1, Math.max(0, raw));
  return (near * far) / (far - inside * (far - near));
}

/**
 * Raw value of a depth in meters: the inverse of `processDepth`.
 * @param {number} depth
 * @param {number} near
 * @param {number} far
 */
export function metricToRaw(depth, near, far) {
  const inside = Math.min(far, Math.max(near, depth));
  return (far - (near * far) / inside) / (far - near);
}

const FLOATS = new Float32Array(1);
const BITS = new Int32Array(FLOATS.buffer);

/**
 * The float32 that follows (`way` 1) or precedes (`way` -1) a positive one.
 * @param {number} value
 * @param {number} way
 */
function neighborFloat(value, way) {
  FLOATS[0] = value;
  BITS[0] += way;
  return FLOATS[0];
}

/**
 * The two levels of an unsigned buffer of `bits` bits that enclose a value from 0 to 1.
 * @param {number} value
 * @param {number} bits
 * @returns {Pair}
 */
export function integerLevels(value, bits) {
  const last = 2 ** bits - 1;
  const level = Math.min(last - 1, Math.floor(value * last));
  return [level / last, (level + 1) / last];
}

/**
 * The two neighboring float32 numbers that enclose a value from 0 to 1.
 * @param {number} value
 * @returns {Pair}
 */
export function floatLevels(value) {
  let low = Math.fround(value);
  if (low > value) low = neighborFloat(low, -1);
  if (low >= 1) low = neighborFloat(1, -1);
  return [low, neighborFloat(low, 1)];
}

/**
 * How many millimeters lie between two raw values; does not subtract two nearly equal depths.
 * @param {Pair} levels
 * @param {number} near
 * @param {number} far
 */
export function gapMm([low, high], near, far) {
  const span = far - near;
  return (1000 * near * far * span * (high - low)) / ((far - low * span) * (far - high * span));
}

/**
 * The same for a buffer in reversed order, 1 at the near plane and 0 at the far plane.
 * @param {Pair} levels
 * @param {number} near
 * @param {number} far
 */
export function reversedGapMm([low, high], near, far) {
  const span = far - near;
  return (1000 * near * far * span * (high - low)) / ((near + low * span) * (near + high * span));
}
