// The middle of the largest region, exactly as labutils.find_object_centroid: outlines as
// cv2.findContours follows them (Suzuki and Abe; external ones only, eight neighbors), areas and
// moments of the polygons they make. All sums are whole numbers, so nothing is rounded.

const [UNSEEN, INNER, OUTER] = [1, 2, 3]; // OUTER: what lies to the right of it is outside
// directions clockwise from the right: x grows to the right, y down
const STEP_X = [1, 1, 0, -1, -1, -1, 0, 1];
const STEP_Y = [0, 1, 1, 1, 0, -1, -1, -1];
const TO_THE_LEFT = 4;

/**
 * Make the search for masks of a size; it takes them as bits, see markRange.
 * @param {number} width
 * @param {number} height
 */
export function makeRegionFinder(width, height) {
  const stride = width + 2; // a rim of background saves every check for the border
  const cells = new Uint8Array(stride * (height + 2));
  const steps = STEP_X.map((x, turn) => x + STEP_Y[turn] * stride);
  const sums = { area: 0, alongX: 0, alongY: 0 }; // 2, 6 and 6 times area and moments
  const best = { area: 0, alongX: 0, alongY: 0 };

  return {
    /** The mask, a byte per pixel, with a rim one pixel wide: not zero is inside. */
    cells,
    /**
     * Read a mask; returns how many pixels are inside.
     * @param {Uint32Array} bits
     */
    load(bits) {
      let count = 0;
      for (let y = 1, word = 0; y <= height; y++) {
        const rowStart = y * stride + 1;
        for (let x = 0; x < width; x += 32) {
          const end = rowStart + Math.min(x + 32, width);
          let rest = bits[word++];
          for (let at = rowStart + x; at < end; at++, rest >>>= 1) {
            cells[at] = rest & 1;
            count += rest & 1;
          }
        }
      }
      return count;
    },
    /**
     * The centroid [x, y] of the largest region of the mask read last, or null. Call it once.
     * @returns {Pair | null}
     */
    findCentroid() {
      best.area = 0;
      for (let y = 1; y <= height; y++) {
        let mark = OUTER; // the last one in this row: it tells whether we are inside an outline
        for (let at = y * stride + 1, end = at + width; at < end; at++) {
          if (cells[at] === 0) continue;
          if (cells[at] === UNSEEN && mark === OUTER && cells[at - 1] === 0) {
            followOutline(cells, steps, at, stride, sums);
            // OpenCV lists the last outline first, and of equal ones the first listed wins
            if (sums.area && sums.area >= best.area) Object.assign(best, sums);
          }
          if (cells[at] !== UNSEEN) mark = cells[at];
        }
      }
      if (!best.area) return null; // nothing, or only lines and dots
      /** @param {number} moment */
      const divide = (moment) => Math.floor(moment / (3 * best.area));
      return [divide(best.alongX), divide(best.alongY)];
    },
  };
}

/**
 * Follow the outline whose first pixel in reading order is `start`: mark it, and sum it up.
 * @param {Uint8Array} cells
 * @param {number[]} steps
 * @param {number} start
 * @param {number} stride
 * @param {Sums} sums
 */
function followOutline(cells, steps, start, stride, sums) {
  sums.area = 0;
  let turn = TO_THE_LEFT;
  do turn = (turn + 1) & 7;
  while (!cells[start + steps[turn]] && turn !== TO_THE_LEFT);
  if (turn === TO_THE_LEFT) {
    cells[start] = OUTER; // a single pixel
    return;
  }
  const last = start + steps[turn];
  let x = (start % stride) - 1;
  let y = Math.floor(start / stride) - 1;
  let [area, alongX, alongY] = [0, 0, 0];
  for (let at = start; ; ) {
    const back = turn;
    do turn = (turn + 7) & 7;
    while (!cells[at + steps[turn]]);
    // direction 0, to the right, was tried on the way and is outside
    if (back > 0 && turn >= back) cells[at] = OUTER;
    else if (cells[at] === UNSEEN) cells[at] = INNER;
    const [stepX, stepY] = [STEP_X[turn], STEP_Y[turn]];
    const cross = stepX * y - x * stepY; // twice the triangle that this step spans with (0, 0)
    area += cross;
    alongX += cross * (2 * x + stepX);
    alongY += cross * (2 * y + stepY);
    const next = at + steps[turn];
    if (next === start && at === last) break;
    at = next;
    x += stepX;
    y += stepY;
    turn = (turn + 4) & 7;
  }
  Object.assign(sums, { area, alongX, alongY });
}
