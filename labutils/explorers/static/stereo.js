// Stereo baseline: a point, where the right eye sees it, and how well its depth can be known.

import { toSteps } from "./_depth_picture.js";
import { defineView, drawOnChange, getContext, make, makeCanvas } from "./_frame.js";
import { makePicker } from "./_picker.js";
import { makePlot, toPath } from "./_plot.js";
import { decodePng, toImageData } from "./_png.js";
import { formatInterval, makeRays } from "./_rays.js";
import { addShape, setShape } from "./_shapes.js";
import { HIDDEN, OUTSIDE } from "./_shared.js";
import {
  findDisparity,
  findInterval,
  findLargestError,
  findLinearError,
  findRightState,
} from "./_stereo.js";

const [NEAREST, FARTHEST, CURVE_STEPS] = [0.1, 10, 100];

export default defineView("stereo", start);

/**
 * @param {StereoModel} model
 * @param {Frame} frame
 */
async function start(model, frame) {
  const picture = toImageData(await decodePng(model.get("rgb_png")));
  const { width, height, data } = await decodePng(model.get("depth_png"));
  const step = model.get("depth_step");
  const valid = toSteps(model.get("valid_m"), step);
  const K = model.get("K");
  const row = new Float64Array(width);

  const canvas = makeCanvas(frame.stage, width, height, "Picture of the left eye");
  getContext(canvas).putImageData(picture, 0, 0);
  const holder = makePicker({
    model,
    frame,
    canvas,
    label: "Picture of the left eye: choose a point",
  });
  const marks = makeRightMark(holder, width, height);
  makeKey(frame.stage);
  const pair = make("div", "explorer-pair", frame.stage);
  const top = makeRays(pair);
  const curve = makeErrorCurve(pair);

  drawOnChange(model, frame, () => {
    const [u, v] = model.get("pixel");
    const baseline = model.get("baseline_mm") / 1000;
    const error = model.get("error_px");
    for (let i = 0; i < width; i++) {
      const steps = u === undefined ? 0 : data[v * width + i];
      row[i] = steps > valid[0] && steps < valid[1] ? steps * step : 0;
    }
    const values = describePair(u, row, K[0][0], baseline, error);
    marks.show(values, u, v);
    top.show(values, u, K, baseline, error);
    curve.show(values, K[0][0], baseline, error);
    frame.tell(inWords(values, [u, v], baseline, error), values);
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
    const none = { depth: null, disparity: null, u_right: null, right: null };
    return { ...none, z_near: null, z_far: null, error_mm: null, error_linear_mm: null };
  }
  const disparity = findDisparity(depth, focal, baseline);
  const [zNear, zFar] = findInterval(disparity, error, focal, baseline);
  const largest = findLargestError(depth, error, focal, baseline);
  return {
    depth,
    disparity,
    u_right: u - disparity,
    right: findRightState(u, row, focal, baseline),
    z_near: zNear,
    z_far: zFar,
    error_mm: largest === null ? null : 1000 * largest,
    error_linear_mm: 1000 * findLinearError(depth, error, focal, baseline),
  };
}

/**
 * A second mark where the right eye sees the point, and a line to it as long as the disparity.
 * @param {Element} holder
 * @param {number} width
 * @param {number} height
 */
function makeRightMark(holder, width, height) {
  const line = make("div", "explorer-disparity", holder);
  const mark = make("div", "explorer-mark explorer-right-mark", holder);
  return {
    /**
     * @param {StereoValues} values
     * @param {number} u
     * @param {number} v
     */
    show({ u_right, right }, u, v) {
      line.hidden = u_right === null;
      mark.hidden = u_right === null || right === OUTSIDE;
      if (u_right === null) return;
      const from = Math.max(u_right, -0.5);
      line.style.left = `${((from + 0.5) / width) * 100}%`;
      line.style.width = `${((u - from) / width) * 100}%`;
      line.style.top = mark.style.top = `${((v + 0.5) / height) * 100}%`;
      mark.style.left = line.style.left;
      mark.classList.toggle("hidden-there", right === HIDDEN);
    },
  };
}

/** @param {Element} parent */
function makeKey(parent) {
  const key = make("div", "explorer-key", parent);
  for (const [shape, text] of [
    ["", "the point in this picture, of the left eye"],
    ["explorer-right-mark", "its place in the right eye's picture"],
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
 * Error over depth, both logarithmic: a straight line is a power, and its slope is two.
 * @param {Element} parent
 */
function makeErrorCurve(parent) {
  /** @param {number} mm */
  const format = (mm) => (mm < 1000 ? `${mm} mm` : `${mm / 1000} m`);
  const y = { label: "depth error", log: true, format };
  const x = { label: "depth (m)", log: true };
  const plot = makePlot(parent, { height: 300, left: 66, x, y });
  plot.setLimits([NEAREST, FARTHEST], [0.1, 10000]);
  const { area, inside, above } = plot;
  const beyond = addShape(inside, "rect", { class: "explorer-band", y: area.top });
  setShape(beyond, { height: area.bottom - area.top });
  const linear = addShape(inside, "path", { class: "explorer-rival dashed" });
  const exact = addShape(inside, "path", { class: "explorer-curve" });
  const note = addShape(
    above,
    "text",
    { class: "halo soft", "text-anchor": "end" },
    "no far limit",
  );
  setShape(note, { x: area.right - 4, y: area.top + 16 });
  const point = addShape(above, "circle", { r: 7, class: "explorer-point" });
  const name = addShape(
    above,
    "text",
    { class: "halo soft", "text-anchor": "end" },
    "dashed: Z² e / (f b)",
  );
  setShape(name, { x: area.right - 4, y: area.bottom - 10 });
  return {
    /** @type {(values: StereoValues, focal: number, baseline: number, error: number) => void} */
    show({ depth, error_mm }, focal, baseline, error) {
      /** @type {{ exact: Pair[], linear: Pair[] }} */
      const points = { exact: [], linear: [] };
      for (let i = 0; i <= CURVE_STEPS; i++) {
        const z = NEAREST * (FARTHEST / NEAREST) ** (i / CURVE_STEPS);
        const largest = findLargestError(z, error, focal, baseline);
        const small = findLinearError(z, error, focal, baseline);
        points.linear.push([plot.x(z), plot.y(1000 * small)]);
        if (largest !== null) points.exact.push([plot.x(z), plot.y(1000 * largest)]);
      }
      setShape(linear, { d: toPath(points.linear) });
      setShape(exact, { d: toPath(points.exact) });
      const limit = (focal * baseline) / error;
      const from = plot.x(Math.min(limit, FARTHEST));
      setShape(beyond, { x: from, width: area.right - from });
      note.style.display = area.right - from > 20 ? "" : "none";
      point.style.display = error_mm === null ? "none" : "";
      if (error_mm !== null) {
        const inLimits = Math.min(10000, Math.max(0.1, error_mm));
        setShape(point, { cx: plot.x(Math.max(depth, NEAREST)), cy: plot.y(inLimits) });
      }
      const [one, two] = [1, 2].map((z) => findLargestError(z, error, focal, baseline));
      /** @param {number | null} meters */
      const tell = (meters) =>
        meters === null ? "without limit" : `${(1000 * meters).toFixed(1)} mm`;
      const label = `Depth error over depth: ${tell(one)} at 1 m, ${tell(two)} at 2 m`;
      setShape(plot.svg, { "aria-label": label });
    },
  };
}

/**
 * @param {StereoValues} values
 * @param {Pixel} pixel
 * @param {number} baseline
 * @param {number} error
 */
function inWords(values, [u, v], baseline, error) {
  if (u === undefined) return "Choose a point in the picture.";
  if (values.depth === null)
    return `Pixel (${u}, ${v}) sees no surface, so there is nothing to match.`;
  const hidden = `${values.u_right.toFixed(1)}, but something nearer hides it`;
  const column = [
    "outside its picture",
    `at column ${values.u_right.toFixed(1)}`,
    `at column ${hidden}`,
  ];
  const worst =
    values.error_mm === null
      ? "it could be infinitely far"
      : `up to ${values.error_mm.toFixed(1)} mm off`;
  return (
    `Pixel (${u}, ${v}) at ${values.depth.toFixed(3)} m: disparity ${values.disparity.toFixed(2)} px ` +
    `over ${(1000 * baseline).toFixed(0)} mm; for the right eye it is ${column[values.right]}. ` +
    `A match ${error.toFixed(1)} px off gives ${formatInterval(values.z_near, values.z_far)}: ${worst}.`
  );
}
