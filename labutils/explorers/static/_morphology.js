// Opening and closing with a square of ones, exactly as cv2.morphologyEx with its default border:
// what lies outside the picture never removes a pixel, nor adds one. A word holds 32 pixels of a
// row, so one operation treats 32 at once: radius 6 costs little more than radius 1.

/**
 * Words per row of a bit mask.
 * @param {number} width
 */
export function countWords(width) {
  return Math.ceil(width / 32);
}

/**
 * Make the two operations for masks of a size; they change the mask given.
 * @param {number} width
 * @param {number} height
 */
export function makeMorphology(width, height) {
  const stride = countWords(width);
  const wide = new Uint32Array(stride * height); // grown along the rows, not yet along the columns
  const tail = width % 32 ? 2 ** (width % 32) - 1 : 0xffffffff; // pixels in the last word of a row

  /**
   * @param {Uint32Array} bits
   * @param {number} radius
   */
  const dilate = (bits, radius) => {
    growRows(bits, wide, stride, radius);
    if (tail !== 0xffffffff) for (let i = stride - 1; i < wide.length; i += stride) wide[i] &= tail;
    growColumns(wide, bits, stride, radius);
  };
  // what a square does not fit into is what another square touches: erosion grows the background
  /**
   * @param {Uint32Array} bits
   * @param {number} radius
   */
  const erode = (bits, radius) => {
    invert(bits);
    dilate(bits, radius);
    invert(bits);
  };
  /** @param {Uint32Array} bits */
  const invert = (bits) => {
    for (let i = 0; i < bits.length; i++) bits[i] = ~bits[i];
    for (let i = stride - 1; i < bits.length; i += stride) bits[i] &= tail;
  };
  return {
    /**
     * @param {Uint32Array} bits
     * @param {number} radius
     */
    open(bits, radius) {
      if (radius === 0) return;
      erode(bits, radius);
      dilate(bits, radius);
    },
    /**
     * @param {Uint32Array} bits
     * @param {number} radius
     */
    close(bits, radius) {
      if (radius === 0) return;
      dilate(bits, radius);
      erode(bits, radius);
    },
  };
}

/**
 * Set every pixel that has a set one at most `radius` (below 32) to its left or right.
 * @param {Uint32Array} from
 * @param {Uint32Array} to
 * @param {number} stride
 * @param {number} radius
 */
function growRows(from, to, stride, radius) {
  for (let row = 0; row < from.length; row += stride) {
    let left = 0;
    let here = from[row];
    for (let i = row, last = row + stride - 1; i <= last; i++) {
      const right = i < last ? from[i + 1] : 0;
      let grown = here;
      if (left | here | right) {
        for (let k = 1; k <= radius; k++) {
          grown |= (here << k) | (left >>> (32 - k)) | (here >>> k) | (right << (32 - k));
        }
      }
      to[i] = grown;
      left = here;
      here = right;
    }
  }
}

/**
 * Set every pixel that has a set one at most `radius` above or below.
 * @param {Uint32Array} from
 * @param {Uint32Array} to
 * @param {number} stride
 * @param {number} radius
 */
function growColumns(from, to, stride, radius) {
  const reach = radius * stride;
  for (let i = 0; i < from.length; i++) {
    const first = i < reach ? i % stride : i - reach;
    const end = Math.min(i + reach + 1, from.length);
    let grown = 0;
    for (let j = first; j < end; j += stride) grown |= from[j];
    to[i] = grown;
  }
}
