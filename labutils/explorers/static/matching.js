// Matching: a window of the left picture, where the right one fits it best, and the cost of every
// disparity. What the reader points at, a pixel or a disparity on the curve, is marked everywhere.

import { makeCloseUp } from "./_close_up.js";
import { makeCostCurve } from "./_cost_curve.js";
import { defineView, drawOnChange, getContext, make, makeCanvas, setTraits } from "./_frame.js";
import { followPointer, makeTag } from "./_hover.js";
import { describeMatch } from "./_matching.js";
import { addNoise, makeNoise } from "./_noise.js";
import { makePicker } from "./_picker.js";
import { decodePng } from "./_png.js";
import { makeEyeName } from "./_right_eye.js";
import { makeSearchStrip, placeWindow } from "./_search_strip.js";
import { HIDDEN, OUTSIDE } from "./_shared.js";
import { makeSizes, makeWindows } from "./_windows.js";

const LONGEST =
  "Pixel (600, 400): 100.25 px, truth 100.25 px: 100.25 px off. Depth 10.000 m, truth 10.000 m: " +
  "1,000 mm too near. Hidden from the right camera.";

export default defineView("matching", start);

/**
 * @param {MatchingModel} model
 * @param {Frame} frame
 */
async function start(model, frame) {
  const scene = await readScene(model);
  const { width, height } = scene;
  const noisy = makeNoisyPair(scene);

  const canvas = makeCanvas(frame.stage, width, height, "Left picture");
  const holder = makePicker({ model, frame, canvas, label: "Left picture: choose a pixel" });
  const box = make("div", "explorer-box-mark", holder);
  makeEyeName(holder, "left");
  const tag = makeTag(holder);
  const strip = makeSearchStrip(frame.stage, scene);
  /** @type {(() => void) | undefined} */
  let again;
  let pointedDisparity = /** @type {number | null} */ (null);
  makePlaces(model, frame.side);
  const curves = make("div", "explorer-curves", frame.side);
  const curve = makeCostCurve(curves, model.get("max_disparity"), (disparity) => {
    pointedDisparity = disparity;
    again?.();
  });
  const closeUp = makeCloseUp(curves);
  const sizes = makeSizes(curves);
  const windows = makeWindows(frame.side);
  const context = getContext(canvas);
  frame.reserve(LONGEST);

  const pointer = followPointer(canvas, model, frame, () => again?.());
  again = drawOnChange(model, frame, () => {
    const [window, search] = [model.get("window"), model.get("search")];
    if (noisy.add(model.get("noise"))) context.putImageData(noisy.leftImage, 0, 0);
    const picked = model.get("pixel");
    const hovered = pointer.pixel;
    const looked = hovered ?? picked;
    const values = describeMatch(scene, picked, window, search);
    const seen = hovered ? describeMatch(scene, hovered, window, search) : values;
    const { disparity, truth } = seen;
    const tried = seen.costs.length;
    const pointed = pointedDisparity !== null && pointedDisparity < tried ? pointedDisparity : null;
    box.hidden = looked.length === 0;
    placeWindow(box, looked[0], looked[1], window, scene);
    strip.show(noisy.rightImage, looked, window, { tried, found: disparity, truth, pointed });
    curve.show(seen, window, search);
    closeUp.show(seen);
    sizes.show(seen.errors_px, window);
    const isPointed = pointed !== null;
    windows.show(scene, looked, window, { found: pointed ?? disparity, isPointed, truth });
    if (hovered) tag.show(inShort(seen), [(hovered[0] + 0.5) / width, (hovered[1] + 0.5) / height]);
    else tag.hide();
    frame.tell(inWords(seen, looked), values);
  });
}

/**
 * Read the pictures and the truth; `left` and `right` are what is matched, with noise in them.
 * @param {MatchingModel} model
 */
async function readScene(model) {
  const [left, right] = await Promise.all([
    decodePng(model.get("left_png")),
    decodePng(model.get("right_png")),
  ]);
  const { width, height } = left;
  const step = model.get("disparity_step");
  const hasTruth = model.get("truth_png").byteLength > 0;
  const truth = hasTruth ? (await decodePng(model.get("truth_png"))).data : new Uint16Array(0);
  return {
    width,
    height,
    clean: { left: left.data, right: right.data },
    left: new Uint8ClampedArray(width * height),
    right: new Uint8ClampedArray(width * height),
    product: model.get("K")[0][0] * model.get("baseline"),
    /** @param {number} v */
    readRow: (v) =>
      Float64Array.from(truth.subarray(v * width, (v + 1) * width), (steps) => steps * step),
  };
}

/**
 * Make what adds noise to both pictures, and paints them.
 * @param {Awaited<ReturnType<typeof readScene>>} scene
 */
function makeNoisyPair({ width, height, clean, left, right }) {
  const count = width * height;
  const noise = [0, 1].map((seed) => makeNoise(count, seed));
  const [leftImage, rightImage] = [0, 1].map(() => new ImageData(width, height));
  let current = -1;
  return {
    leftImage,
    rightImage,
    /** Set the noise; returns whether the pictures have changed. */
    add(/** @type {number} */ sigma) {
      if (sigma === current) return false;
      current = sigma;
      addNoise(clean.left, noise[0], sigma, left);
      addNoise(clean.right, noise[1], sigma, right);
      paint(left, leftImage);
      paint(right, rightImage);
      return true;
    },
  };
}

/**
 * @param {Uint8ClampedArray} gray
 * @param {ImageData} image
 */
function paint(gray, image) {
  const out = new Uint32Array(image.data.buffer);
  for (let i = 0; i < gray.length; i++) out[i] = 0xff000000 | (0x10101 * gray[i]);
}

/**
 * Make a button for each pixel that is worth a look.
 * @param {MatchingModel} model
 * @param {Element} parent
 */
function makePlaces(model, parent) {
  const places = model.get("places");
  if (!places.length) return;
  const row = make("div", "explorer-places", parent);
  for (const [name, pixel] of places) {
    const button = make("button", "explorer-button", row);
    button.type = "button";
    button.textContent = name;
    button.addEventListener("click", () => setTraits(model, { pixel: [...pixel] }));
  }
}

/**
 * @param {MatchValues} values
 * @param {Pixel} pixel
 */
function inWords(values, [u, v]) {
  if (u === undefined) return "Choose a pixel in the left picture.";
  const { subpixel, truth, error_px, right } = values;
  const pixel = `Pixel (${u}, ${v})`;
  if (subpixel === null) return `${pixel}: the window reaches beyond the picture.`;
  const found = `${pixel}: ${subpixel.toFixed(2)} px`;
  if (truth === null || error_px === null) return `${found}. ${inMeters(values)}`;
  const off = `truth ${truth.toFixed(2)} px: ${Math.abs(error_px).toFixed(2)} px off`;
  return `${found}, ${off}. ${inMeters(values)}${inRight(right)}`;
}

/** @param {MatchValues} values */
function inMeters({ depth, true_depth, depth_error_mm }) {
  if (depth === null) return "Infinitely far.";
  const found = `Depth ${depth.toFixed(3)} m`;
  if (true_depth === null || depth_error_mm === null) return `${found}.`;
  const mm = Math.round(Math.abs(depth_error_mm)).toLocaleString("en-US");
  const side = depth_error_mm > 0 ? "too far" : "too near";
  return `${found}, truth ${true_depth.toFixed(3)} m: ${mm} mm ${side}.`;
}

/** @param {number | null} right */
function inRight(right) {
  if (right === HIDDEN) return " Hidden from the right camera.";
  return right === OUTSIDE ? " Outside the right picture." : "";
}

/** @param {MatchValues} values */
function inShort({ subpixel, error_px }) {
  if (subpixel === null) return "no window";
  const off = error_px === null ? "" : `, off by ${Math.abs(error_px).toFixed(1)} px`;
  return `${subpixel.toFixed(1)} px${off}`;
}
