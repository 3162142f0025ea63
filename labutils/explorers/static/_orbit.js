// The place a reader looks from. Mirrors labutils.explorers._cloud_poster.make_view_transform.
//
// A transform is twelve numbers: three rows of a rotation, each followed by its part of the shift.
// One orbits in a frame with x right, y down and z forward.

const [MIN_DISTANCE, MAX_DISTANCE] = [0.1, 20]; // meters
const NEAREST = 0.02; // meters: what is closer to the eye is not drawn
const STEP_BACK = 1.25; // along an axis a cloud looks larger than from a corner
export const STAY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];

/**
 * The transform from the frame one orbits in to the eye.
 * @param {Orbit} orbit
 * @returns {Transform}
 */
export function makeEyeTransform({ azimuth_deg, elevation_deg, distance, target }) {
  const [azimuth, elevation] = [(azimuth_deg * Math.PI) / 180, (elevation_deg * Math.PI) / 180];
  const [ca, sa] = [Math.cos(azimuth), Math.sin(azimuth)];
  const [ce, se] = [Math.cos(elevation), Math.sin(elevation)];
  const rows = [
    [ca, 0, sa],
    [sa * se, ce, -ca * se],
    [-sa * ce, se, ca * ce],
  ];
  const shift = rows.map((row) => -row[0] * target[0] - row[1] * target[1] - row[2] * target[2]);
  shift[2] += distance;
  return rows.flatMap((row, i) => [...row, shift[i]]);
}

/**
 * First `second`, then `first`.
 * @param {Transform} first
 * @param {Transform} second
 * @returns {Transform}
 */
export function joinTransforms(first, second) {
  const out = [];
  for (const i of [0, 4, 8]) {
    for (let j = 0; j < 4; j++) {
      const sum =
        first[i] * second[j] + first[i + 1] * second[4 + j] + first[i + 2] * second[8 + j];
      out.push(sum + (j === 3 ? first[i + 3] : 0));
    }
  }
  return out;
}

/**
 * A point through a transform.
 * @param {Transform} transform
 * @param {number[]} point
 * @returns {Triple}
 */
export function movePoint(transform, [x, y, z]) {
  /** @param {number} i */
  const row = (i) =>
    transform[i] * x + transform[i + 1] * y + transform[i + 2] * z + transform[i + 3];
  return [row(0), row(4), row(8)];
}

/**
 * Focal length of the reader's own view, in pixels of a picture this tall.
 * @param {number} viewFovDegrees
 * @param {number} height
 */
export function focalOfView(viewFovDegrees, height) {
  return height / 2 / Math.tan((viewFovDegrees * Math.PI) / 360);
}

/**
 * Ends of a line of the eye's frame in pixels; [] where all of it lies behind the eye.
 * @param {Triple} from
 * @param {Triple} to
 * @param {number} focal
 * @param {number} width
 * @param {number} height
 * @returns {Pair[]}
 */
export function projectLine(from, to, focal, width, height) {
  if (from[2] < NEAREST && to[2] < NEAREST) return [];
  /**
   * @param {Triple} point
   * @param {Triple} other
   * @returns {Pair}
   */
  const place = (point, other) => {
    let [x, y, z] = point;
    if (z < NEAREST) {
      const share = (NEAREST - z) / (other[2] - z); // cut where it passes the eye
      [x, y, z] = [x + share * (other[0] - x), y + share * (other[1] - y), NEAREST];
    }
    return [(focal * x) / z + width / 2, (focal * y) / z + height / 2];
  };
  return [place(from, to), place(to, from)];
}

/**
 * Walk around: degrees to the side and up; never over the pole.
 * @param {Orbit} orbit
 * @param {number} azimuth
 * @param {number} elevation
 * @returns {Orbit}
 */
export function turnOrbit(orbit, azimuth, elevation) {
  return {
    ...orbit,
    azimuth_deg: (orbit.azimuth_deg + azimuth) % 360,
    elevation_deg: Math.min(90, Math.max(-90, orbit.elevation_deg + elevation)),
  };
}

/**
 * Come closer (factor below 1) or go away.
 * @param {Orbit} orbit
 * @param {number} factor
 * @returns {Orbit}
 */
export function zoomOrbit(orbit, factor) {
  const distance = Math.min(MAX_DISTANCE, Math.max(MIN_DISTANCE, orbit.distance * factor));
  return { ...orbit, distance };
}

/**
 * Three views by name, for a camera whose pose in the orbit's frame is a transform.
 * @param {string} name
 * @param {Orbit} start
 * @param {Transform} camera
 * @returns {Orbit}
 */
export function makeNamedView(name, start, camera) {
  const [forward, center] = [
    [camera[2], camera[6], camera[10]],
    [camera[3], camera[7], camera[11]],
  ];
  const azimuth = (Math.atan2(-forward[0], forward[2]) * 180) / Math.PI;
  const back = { ...start, distance: start.distance * STEP_BACK };
  if (name === "above") return { ...back, azimuth_deg: azimuth, elevation_deg: 90 };
  if (name === "side") return { ...back, azimuth_deg: azimuth + 90, elevation_deg: 0 };
  const distance = Math.hypot(...start.target.map((value, i) => value - center[i]));
  return {
    azimuth_deg: azimuth,
    elevation_deg: (Math.asin(Math.min(1, Math.max(-1, forward[1]))) * 180) / Math.PI,
    distance,
    target: center.map((value, i) => value + distance * forward[i]),
  };
}
