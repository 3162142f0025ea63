// From a picture and limits to a mask and what is in it: what labutils.segment_by_color and
// find_object_centroid do, with any radius. Buffers are made once per picture.

import { findExcluding, markRange, rgbToHsv } from "./_color.js";
import { countWords, makeMorphology } from "./_morphology.js";
import { makeRegionFinder } from "./_regions.js";

/**
 * Prepare a picture: { width, height, channels, data }, red first, a byte per value.
 * @param {Picture} picture
 */
export function makeSegmenter({ width, height, channels, data }) {
  const planes = rgbToHsv(data, width * height, channels);
  const bits = new Uint32Array(countWords(width) * height);
  const morphology = makeMorphology(width, height);
  const regions = makeRegionFinder(width, height);
  const stride = width + 2;
  /** @param {number} at */
  const isSelected = (at) =>
    regions.cells[(Math.floor(at / width) + 1) * stride + (at % width) + 1] !== 0;
  return {
    width,
    height,
    /** The mask made last, a byte per pixel inside a rim one pixel wide; not zero is inside. */
    mask: regions.cells,
    /**
     * Make the mask; returns what the read-out tells of it.
     * @param {HsvLimits} limits
     * @param {number} openRadius
     * @param {number} closeRadius
     */
    segment(limits, openRadius, closeRadius) {
      markRange(planes, limits, width, bits);
      morphology.open(bits, openRadius);
      morphology.close(bits, closeRadius);
      const count = regions.load(bits);
      return { share: count / (width * height), count, centroid: regions.findCentroid() };
    },
    /**
     * Intersection over union of the mask made last and of the pixels that should be in it.
     * @param {Uint32Array} truth their places, row by row
     * @param {number} count how many are in the mask
     */
    findIou(truth, count) {
      let both = 0;
      for (const at of truth) both += Number(isSelected(at));
      return both / (truth.length + count - both);
    },
    /**
     * What the read-out tells of a pixel [u, v] of the mask made last; [] is none.
     * @param {Pixel} pixel
     * @param {HsvLimits} limits
     * @returns {PixelValues}
     */
    describePixel([u, v], limits) {
      if (u === undefined || u >= width || v >= height) {
        return {
          pixel_rgb: null,
          pixel_hsv: null,
          pixel_excluded_by: [],
          pixel_inside: null,
          pixel_selected: null,
        };
      }
      const at = v * width + u;
      /** @type {Triple} */
      const hsv = [planes.h[at], planes.s[at], planes.v[at]];
      const excluding = findExcluding(hsv, limits);
      return {
        pixel_rgb: [...data.subarray(at * channels, at * channels + 3)],
        pixel_hsv: hsv,
        pixel_excluded_by: excluding,
        pixel_inside: excluding.length === 0,
        pixel_selected: isSelected(at),
      };
    },
  };
}
