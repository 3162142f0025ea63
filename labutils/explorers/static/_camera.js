// The pinhole camera, as in labutils.cameras and labutils.projection. Angles in degrees, as on a slider.

/**
 * Focal length in pixels of a picture `height` pixels tall: half the height over tan of half the angle.
 * @param {number} fovDegrees
 * @param {number} height
 */
export function focalFromFov(fovDegrees, height) {
  return height / 2 / Math.tan((fovDegrees * Math.PI) / 360);
}

/**
 * The angle, in degrees, under which `size` pixels are seen with a focal length in pixels.
 * @param {number} focal
 * @param {number} size
 */
export function fovFromFocal(focal, size) {
  return (2 * Math.atan(size / (2 * focal)) * 180) / Math.PI;
}

/**
 * Intrinsic matrix, rows of three; (0, 0) is the center of the first pixel.
 * @param {number} fovDegrees
 * @param {number} width
 * @param {number} height
 */
export function intrinsicsMatrix(fovDegrees, width, height) {
  const focal = focalFromFov(fovDegrees, height);
  return [
    [focal, 0, (width - 1) / 2],
    [0, focal, (height - 1) / 2],
    [0, 0, 1],
  ];
}

/**
 * The point that pixel (u, v) shows at a depth: x right, y down, z forward.
 * @param {number} u
 * @param {number} v
 * @param {number} depth
 * @param {Matrix} K
 * @returns {Triple}
 */
export function pixelToPoint(u, v, depth, K) {
  return [((u - K[0][2]) / K[0][0]) * depth, ((v - K[1][2]) / K[1][1]) * depth, depth];
}
