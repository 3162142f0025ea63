// Stereo baseline: a point, where the right eye sees it, and how well its depth can be known. What
// the reader points at, a pixel or a depth on the curve, is marked everywhere.

import { toStep, toSteps } from "./_depth_picture.js";
import { makeErrorCurve } from "./_error_curve.js";
import { defineView, drawOnChange, getContext, make, makeCanvas } from "./_frame.js";
import { followPointer, makeSpotlight, makeTag } from "./_hover.js";
import { makePicker } from "./_picker.js";
import { decodePng, toImageData } from "./_png.js";
import { formatInterval, makeRays } from "./_rays.js";
import { makeEyeName, makeRightEye } from "./_right_eye.js";
import { SEEN } from "./_shared.js";
import {
  findDisparity,
  findInterval,
  findLargestError,
  findLinearError,
  findRightState,
} from "./_stereo.js";

const LONGEST =
  "Pixel (600, 400), 1.715 m: disparity 21.62 px, in the right eye column 578.4, hidden there. " +
  "A match 0.5 px off leaves 1.676 to 1.756 m.";

export default defineView("stereo", start);

/**
 * @param {StereoModel} model
 * @param {Frame} frame
 */
async function start(model, frame) {
  const picture = toImageData(await decodePng(model.get("rgb_png")));
  const depth = await decodePng(model.get("depth_png"));
  const { width, height } = depth;
  const step = model.get("depth_step");
  const valid = toSteps(model.get("valid_m"), step);
  const depths = Float64Array.from(depth.data, (steps) =>
    steps > valid[0] && steps < valid[1] ? steps * step : 0,
  );
  const K = model.get("K");

  const canvas = makeCanvas(frame.stage, width, height, "Picture of the left eye");
  getContext(canvas).putImageData(picture, 0, 0);
  const label = "Picture of the left eye: choose a point";
  const holder = makePicker({ model, frame, canvas, label });
  const spotlight = makeSpotlight(holder, depth);
  const eye = makeRightEye(frame.stage, holder, picture, depths);
  makeEyeName(holder, "left eye");
  const tag = makeTag(holder);
  const pair = make("div", "explorer-pair explorer-stereo-plots", frame.side);
  const top = makeRays(pair);
  const curve = makeErrorCurve(pair, (between) => {
    spotlight.show(between && [toStep(between[0], step), toStep(between[1], step)]);
  });

  makeKey(frame.side);
  frame.reserve(LONGEST);

  const pointer = followPointer(canvas, model, frame, () => again());
  const again = drawOnChange(model, frame, () => {
    const hovered = pointer.pixel;
    const baseline = model.get("baseline_mm") / 1000;
    const error = model.get("error_px");
    const describe = (/** @type {Pixel} */ [u, v]) =>
      describePair(u, depths.subarray(width * v, width * (v + 1)), K[0][0], baseline, error);
    const values = describe(model.get("pixel"));
    const looked = hovered ?? model.get("pixel");
    const seen = hovered ? describe(hovered) : values;
    eye.show(seen, looked, K[0][0], baseline, hovered !== null);
    top.show(seen, looked[0], K, baseline, error);
    curve.show(seen, K[0][0], baseline, error);
    if (hovered) tag.show(inShort(seen), [(hovered[0] + 0.5) / width, (hovered[1] + 0.5) / height]);
    else tag.hide();
    frame.tell(inWords(seen, looked, error), values);
  });
}

/**
 * What two eyes make of pixel u of a row of depths; the same as StereoView.compute in Python.
 * @param {number | undefined} u
 * @param {ArrayLike<number>} row
 * @param {number} focal
 * @param {number} baseline
 * @param {number} error
 * @returns {StereoValues}
 */
export function describePair(u, row, focal, baseline, error) {
  const depth = u === undefined ? 0 : row[u];
  if (u === undefined || !depth) {
    const none = { depth: null, shared_depth: null, disparity: null, u_right: null, right: null };
    return { ...none, z_near: null, z_far: null, error_mm: null, error_linear_mm: null };
  }
  const disparity = findDisparity(depth, focal, baseline);
  const [zNear, zFar] = findInterval(disparity, error, focal, baseline);
  const largest = findLargestError(depth, error, focal, baseline);
  const right = findRightState(u, row, focal, baseline);
  return {
    depth,
    shared_depth: right === SEEN ? depth : null,
    disparity,
    u_right: u - disparity,
    right,
    z_near: zNear,
    z_far: zFar,
    error_mm: largest === null ? null : 1000 * largest,
    error_linear_mm: 1000 * findLinearError(depth, error, focal, baseline),
  };
}

/** @param {Element} parent */
function makeKey(parent) {
  const key = make("div", "explorer-key", parent);
  for (const [shape, text] of [
    ["", "the point"],
    ["explorer-right-mark", "where the right eye sees it"],
  ]) {
    const item = make("span", "explorer-key-item", key);
    make("span", `explorer-mark explorer-key-mark ${shape}`, item).setAttribute(
      "aria-hidden",
      "true",
    );
    item.append(text);
  }
}

/**
 * @param {StereoValues} values
 * @param {Pixel} pixel
 * @param {number} error
 */
function inWords(values, [u, v], error) {
  if (u === undefined) return "Choose a point in the picture.";
  if (values.depth === null)
    return `Pixel (${u}, ${v}) sees no surface, so there is nothing to match.`;
  const column = `column ${values.u_right.toFixed(1)}`;
  const seen = ["outside its picture", column, `${column}, hidden there`];
  return (
    `Pixel (${u}, ${v}), ${values.depth.toFixed(3)} m: disparity ${values.disparity.toFixed(2)} px, ` +
    `in the right eye ${seen[values.right]}. ` +
    `A match ${error.toFixed(1)} px off leaves ${formatInterval(values.z_near, values.z_far)}.`
  );
}

/** @param {StereoValues} values */
function inShort({ depth, disparity }) {
  return depth === null ? "no surface" : `${depth.toFixed(3)} m, ${disparity.toFixed(1)} px`;
}
