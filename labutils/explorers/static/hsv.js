// HSV limits: what they select, what opening and closing make of it, and where its middle is. The
// same as labutils.segment_by_color and find_object_centroid; a reader's own picture stays here.

import { defineView, drawOnChange, make, makeCanvas, setTraits } from "./_frame.js";
import { makeHueRing } from "./_hue_ring.js";
import { makeOverlay } from "./_overlay.js";
import { acceptPictures } from "./_own_picture.js";
import { makePicker } from "./_picker.js";
import { decodePng } from "./_png.js";
import { makeSegmenter } from "./_segment.js";

export default defineView("hsv", start);

/**
 * @param {HsvModel} model
 * @param {Frame} frame
 */
async function start(model, frame) {
  const scene = await decodePng(model.get("rgb_png"));
  // one place of the scene's shape for every picture, so that nothing moves when it changes
  const place = make("div", "explorer-hsv-picture", frame.stage);
  place.style.aspectRatio = `${scene.width} / ${scene.height}`;
  const canvas = makeCanvas(place, scene.width, scene.height, "The picture");
  const holder = makePicker({
    model,
    frame,
    canvas,
    label: "The picture, dimmed where nothing is selected",
  });
  const ring = makeHueRing(frame.side, model);

  /** @type {ReturnType<typeof makeSegmenter>} */
  let segmenter;
  /** @type {ReturnType<typeof makeOverlay>} */
  let overlay;
  /** @param {Picture} picture */
  const show = (picture) => {
    segmenter = makeSegmenter(picture);
    overlay = makeOverlay(canvas, picture);
    const shrink = Math.min(1, (picture.width * scene.height) / (picture.height * scene.width));
    holder.style.width = `${100 * shrink}%`;
    frame.root.dataset.picture = picture === scene ? "scene" : "own";
  };
  show(scene);
  const draw = drawOnChange(model, frame, () => {
    const limits = readLimits(model);
    const found = segmenter.segment(limits, model.get("open_radius"), model.get("close_radius"));
    overlay.draw(segmenter.mask, model.get("shown"), found.centroid);
    const values = { ...found, ...segmenter.describePixel(model.get("pixel"), limits) };
    ring.show(limits, values.pixel_hsv, values.pixel_rgb);
    frame.tell(describeSelection(values, model.get("pixel")), values);
  });
  acceptPictures({
    frame,
    place,
    size: scene,
    show(picture) {
      show(picture ?? scene);
      setTraits(model, { pixel: [] }); // it was a pixel of another picture
      draw();
    },
  });
}

/**
 * The six limits, [[h, s, v] low, [h, s, v] high].
 * @param {HsvModel} model
 * @returns {HsvLimits}
 */
function readLimits(model) {
  const [saturation, value] = [model.get("saturation_limits"), model.get("value_limits")];
  return [
    [model.get("hue_from"), saturation[0], value[0]],
    [model.get("hue_to"), saturation[1], value[1]],
  ];
}

/**
 * @param {HsvValues} values
 * @param {Pixel} pixel
 */
function describeSelection({ share, count, centroid, ...picked }, pixel) {
  const digits = share > 0 && share < 0.0995 ? 2 : 1;
  const where = centroid ? `(${centroid.join(", ")})` : "none";
  return (
    `Selected: ${(100 * share).toFixed(digits)}% (${count.toLocaleString("en-US")} pixels). Centroid: ${where}.` +
    describePicked(picked, pixel)
  );
}

/**
 * @param {PixelValues} values
 * @param {Pixel} pixel
 */
function describePicked(values, pixel) {
  if (!values.pixel_hsv) return "";
  const [rgb, hsv] = [values.pixel_rgb.join(" "), values.pixel_hsv.join(" ")];
  const told = ` Pixel (${pixel.join(", ")}): RGB ${rgb}, HSV ${hsv}, `;
  const reasons = values.pixel_excluded_by.join(" and by ");
  if (reasons) {
    return `${told}excluded by ${reasons}${values.pixel_selected ? ", filled in by closing" : ""}.`;
  }
  return `${told}inside${values.pixel_selected ? "" : ", removed by opening"}.`;
}
