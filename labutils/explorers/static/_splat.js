// Draw points as squares with a depth test, on the CPU. Mirrors labutils._splat.render_points, but
// a square here is as large as the pixel it came from, seen from where the reader stands.

export const SPLAT_GROWTH = 1.6; // squares overlap, so that slanted surfaces stay closed
export const MAX_SPLAT = 12; // pixels of the page

/**
 * Make room for a picture: the distance of what is drawn at each pixel, and which point it is.
 * @param {number} width
 * @param {number} height
 * @returns {SplatBuffer}
 */
export function makeSplatBuffer(width, height) {
  const distance = new Float32Array(width * height);
  return { width, height, distance, ids: new Int32Array(width * height) };
}

/**
 * Fill the buffer with the nearest point at each pixel, -1 where there is none.
 *
 * `look` has `eyeFromCamera` (see _orbit.js), `focal` in pixels, `K` and `far`. With a `stride` of
 * n only every n-th row and column of the camera's picture is drawn, in squares n times as large.
 * @param {Cloud} cloud
 * @param {Look} look
 * @param {SplatBuffer} buffer
 * @param {number} stride
 */
export function splatPoints(cloud, look, buffer, stride = 1) {
  const { steps, depthStep, minDepth } = cloud;
  const { eyeFromCamera: E, focal, K, far } = look;
  const { width, height, distance, ids } = buffer;
  distance.fill(Infinity);
  ids.fill(-1);
  const [middleX, middleY] = [width / 2, height / 2];
  const footprint = (SPLAT_GROWTH * stride * focal) / K[1][1];
  const largest = MAX_SPLAT * stride;
  for (let v = 0; v < cloud.height; v += stride) {
    const y = (v - K[1][2]) / K[1][1];
    const [rowX, rowY, rowZ] = [E[1] * y + E[2], E[5] * y + E[6], E[9] * y + E[10]];
    for (let u = 0, i = v * cloud.width; u < cloud.width; u += stride, i += stride) {
      const z = steps[i] * depthStep;
      if (z <= minDepth || z >= far) continue;
      const x = (u - K[0][2]) / K[0][0];
      const away = z * (E[8] * x + rowZ) + E[11];
      if (away < 0.02) continue;
      const scale = focal / away;
      const px = (z * (E[0] * x + rowX) + E[3]) * scale + middleX;
      const py = (z * (E[4] * x + rowY) + E[7]) * scale + middleY;
      const half = Math.min(largest, Math.max(1, (footprint * z) / away)) / 2;
      // pixels whose centers lie in the square; at least the one in which the point falls
      const left = Math.max(0, Math.min(Math.floor(px), Math.ceil(px - half - 0.5)));
      const right = Math.min(width - 1, Math.max(Math.floor(px), Math.floor(px + half - 0.5)));
      const top = Math.max(0, Math.min(Math.floor(py), Math.ceil(py - half - 0.5)));
      const bottom = Math.min(height - 1, Math.max(Math.floor(py), Math.floor(py + half - 0.5)));
      for (let row = top; row <= bottom; row++) {
        for (let at = row * width + left, end = row * width + right; at <= end; at++) {
          if (away < distance[at]) {
            distance[at] = away;
            ids[at] = i;
          }
        }
      }
    }
  }
}

/**
 * The point drawn at (x, y), else the closest one drawn within `slack` pixels, else -1.
 * @param {SplatBuffer} buffer
 * @param {number} x
 * @param {number} y
 * @param {number} slack
 */
export function pickDrawn({ width, height, ids }, x, y, slack) {
  const [column, row] = [Math.floor(x), Math.floor(y)];
  let [best, bestSquare] = [-1, slack * slack + 1];
  for (let v = Math.max(0, row - slack); v <= Math.min(height - 1, row + slack); v++) {
    for (let u = Math.max(0, column - slack); u <= Math.min(width - 1, column + slack); u++) {
      const square = (u - column) ** 2 + (v - row) ** 2;
      if (ids[v * width + u] >= 0 && square < bestSquare) {
        [best, bestSquare] = [ids[v * width + u], square];
      }
    }
  }
  return best;
}
