// HSV limits: what they select, what opening and closing make of it, and where its middle is. The
// same as labutils.segment_by_color and find_object_centroid; a reader's own picture stays here.

import { defineView, drawOnChange, make, makeCanvas, setTraits } from "./_frame.js";
import { makeHueRing } from "./_hue_ring.js";
import { makeOverlay } from "./_overlay.js";
import { acceptPictures } from "./_own_picture.js";
import { makePicker } from "./_picker.js";
import { decodePng } from "./_png.js";
import { makeSegmenter } from "./_segment.js";

const LEAST_SHARE = 0.15; // of the place, for either side of a picture
const HINT = "Tap the picture to read a pixel.";
const LONGEST =
  "Selected: 100.0% (307,200 pixels). Centroid: (320, 240). Pixel (320, 240): RGB 100 100 100, " +
  "HSV 100 100 100, excluded by hue, saturation, value, but filled in by closing.";

export default defineView("hsv", start);

/**
 * @param {HsvModel} model
 * @param {Frame} frame
 */
async function start(model, frame) {
  const [scene, truth] = await Promise.all([
    decodePng(model.get("rgb_png")),
    readTruth(model.get("truth_png")),
  ]);
  frame.reserve(LONGEST);
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
    fitInto(holder, picture, scene);
    frame.root.dataset.picture = picture === scene ? "scene" : "own";
    frame.suspendGoal(picture !== scene);
  };
  show(scene);
  const draw = drawOnChange(model, frame, () => {
    const limits = readLimits(model);
    const found = segmenter.segment(limits, model.get("open_radius"), model.get("close_radius"));
    overlay.draw(segmenter.mask, model.get("shown"), found.centroid);
    const isKnown = truth && frame.root.dataset.picture === "scene";
    const iou = isKnown ? segmenter.findIou(truth, found.count) : null;
    const values = { ...found, iou, ...segmenter.describePixel(model.get("pixel"), limits) };
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
 * The places of the pixels to select, row by row; null where nobody knows them.
 * @param {DataView<ArrayBuffer>} png
 */
async function readTruth(png) {
  if (!png.byteLength) return null;
  const { data } = await decodePng(png);
  const places = [];
  for (let at = 0; at < data.length; at++) if (data[at]) places.push(at);
  return Uint32Array.from(places);
}

/**
 * Show a picture as large as its place allows. A very long one would be a line: it is stretched.
 * @param {HTMLElement} holder
 * @param {Picture} picture
 * @param {Picture} place
 */
function fitInto(holder, { width, height }, place) {
  const shape = (width * place.height) / (height * place.width);
  const wide = Math.max(LEAST_SHARE, Math.min(1, shape));
  const high = Math.max(LEAST_SHARE, Math.min(1, 1 / shape));
  holder.style.width = `${100 * wide}%`;
  holder.style.aspectRatio = `${wide * place.width} / ${high * place.height}`;
  holder.classList.toggle("explorer-coarse", 2 * width < place.width && 2 * height < place.height);
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
function describeSelection({ share, count, centroid, iou: _, ...picked }, pixel) {
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
  if (!values.pixel_hsv) return ` ${HINT}`;
  const [rgb, hsv] = [values.pixel_rgb.join(" "), values.pixel_hsv.join(" ")];
  const told = ` Pixel (${pixel.join(", ")}): RGB ${rgb}, HSV ${hsv}, `;
  const reasons = values.pixel_excluded_by.join(", ");
  if (reasons) {
    return `${told}excluded by ${reasons}${values.pixel_selected ? ", but filled in by closing" : ""}.`;
  }
  return `${told}inside${values.pixel_selected ? "" : ", but removed by opening"}.`;
}
