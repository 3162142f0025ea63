// Depth range: which depths get the colors, and where they lie in the raw buffer. What the reader
// points at, a pixel or a bar of a histogram, is marked everywhere.

import { makeColorBar } from "./_color_bar.js";
import { metricToRaw } from "./_depth.js";
import {
  binMetric,
  binRaw,
  countKinds,
  countSteps,
  findBinStarts,
  findKind,
  LEVELS,
  paintDepth,
  readTable,
  toStep,
  toSteps,
} from "./_depth_picture.js";
import { defineView, drawOnChange, getContext, make, makeCanvas } from "./_frame.js";
import { makeHistogram } from "./_histogram.js";
import { followPointer, makeSpotlight, makeTag } from "./_hover.js";
import { makePicker } from "./_picker.js";
import { decodePng } from "./_png.js";
import { FARTHER, INSIDE, NEARER, NO_SURFACE } from "./_shared.js";

const BINS = 50;
const KINDS = ["nearer than the range", "in the range", "farther than the range", "no surface"];

const LONGEST =
  "0.65 to 2.10 m holds 99.9 % of the 300,000 surface pixels. In the raw buffer: 0.9600 to 0.9900. " +
  "Pixel (600, 400): 1.2345 m, raw 0.98765, farther than the range.";

export default defineView("depth-range", start);

/**
 * @param {RangeModel} model
 * @param {Frame} frame
 */
async function start(model, frame) {
  const depth = await decodePng(model.get("depth_png"));
  const { width, height, data: pixels } = depth;
  const step = model.get("depth_step");
  const clip = model.get("clip_m");
  const valid = toSteps(model.get("valid_m"), step);
  const reading = readDepths(model, pixels, valid);

  const pictures = make("div", "explorer-depth", frame.stage);
  const canvas = makeCanvas(pictures, width, height, "Depth");
  const holder = makePicker({ model, frame, canvas, label: "Depth image: read one pixel" });
  const spotlight = makeSpotlight(holder, depth);
  const tag = makeTag(holder);
  const paint = makePainter(model, canvas, pixels, valid);
  const charts = makeCharts(frame.side, model, reading, spotlight.show);
  const bar = makeColorBar(pictures, frame.side);

  frame.reserve(LONGEST);

  const pointer = followPointer(canvas, model, frame, () => again());
  const again = drawOnChange(model, frame, () => {
    const hovered = pointer.pixel;
    const range = model.get("range_m");
    const rangeSteps = toSteps(range, step);
    bar.show(paint(range, rangeSteps), range);
    /** @type {(pixel: Pixel) => PixelReading} */
    const read = ([u, v]) => {
      if (u === undefined) return { pixel_depth: null, pixel_raw: null, pixel_kind: null };
      const steps = pixels[v * width + u];
      const meters = steps ? steps * step : null;
      return {
        pixel_depth: meters,
        pixel_raw: meters === null ? null : metricToRaw(meters, ...clip),
        pixel_kind: findKind(steps, rangeSteps, valid),
      };
    };
    const values = { ...reading.count(range, rangeSteps), ...read(model.get("pixel")) };
    const looked = hovered ?? model.get("pixel");
    const seen = hovered ? read(hovered) : values;
    bar.mark(range, seen.pixel_depth, seen.pixel_kind);
    charts.show(range, values, seen);
    if (hovered) tag.show(inShort(seen), [(hovered[0] + 0.5) / width, (hovered[1] + 0.5) / height]);
    else tag.hide();
    frame.tell(inWords(values, range) + inPixelWords(seen, looked), values);
  });
}

/**
 * What the depth image holds whatever the range is, and what a range holds of it.
 * @param {RangeModel} model
 * @param {ArrayLike<number> & Iterable<number>} pixels
 * @param {Pair} valid
 */
function readDepths(model, pixels, valid) {
  const [step, clip, upper] = [model.get("depth_step"), model.get("clip_m"), model.get("upper_m")];
  const counts = countSteps(pixels);
  const isSurface = (/** @type {number} */ steps) =>
    counts[steps] > 0 && steps > valid[0] && steps < valid[1];
  const closest = step * counts.findIndex((_, steps) => isSurface(steps));
  const farthest = step * counts.findLastIndex((_, steps) => isSurface(steps));
  const bins = {
    metric_bins: binMetric(counts, BINS, upper, step, valid),
    raw_bins: binRaw(counts, BINS, step, valid, clip),
  };
  const end = toStep(upper, step);
  const starts = {
    metric: findBinStarts(BINS, (steps) => Math.floor((steps * BINS) / end), valid),
    raw: findBinStarts(
      BINS,
      (steps) => Math.min(BINS - 1, Math.floor(metricToRaw(steps * step, ...clip) * BINS)),
      valid,
    ),
  };
  return {
    ...bins,
    starts,
    /** @type {(range: Pair, rangeSteps: Pair) => RangeCounts} */
    count([low, high], rangeSteps) {
      const kinds = countKinds(counts, rangeSteps, valid);
      const surfaces = kinds[NEARER] + kinds[INSIDE] + kinds[FARTHER];
      return {
        surfaces,
        left_out: surfaces - kinds[INSIDE],
        share_nearer: (100 * kinds[NEARER]) / surfaces,
        share_inside: (100 * kinds[INSIDE]) / surfaces,
        share_farther: (100 * kinds[FARTHER]) / surfaces,
        no_surface: kinds[NO_SURFACE],
        width_percent: (100 * (high - low)) / Math.max(farthest - closest, step),
        raw_range: [metricToRaw(low, ...clip), metricToRaw(high, ...clip)],
        raw_closest: metricToRaw(closest, ...clip),
        ...bins,
      };
    },
  };
}

/**
 * Make what paints the depth image where range or colors have changed; it returns the colors.
 * @param {RangeModel} model
 * @param {HTMLCanvasElement} canvas
 * @param {ArrayLike<number>} pixels
 * @param {Pair} valid
 */
function makePainter(model, canvas, pixels, valid) {
  const step = model.get("depth_step");
  const bytes = model.get("color_tables");
  const all = new Uint8Array(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const tables = model.get("color_names").map((_, place) => readTable(all, place * 768));
  const context = getContext(canvas);
  const image = context.createImageData(canvas.width, canvas.height);
  const out = new Uint32Array(image.data.buffer);
  const palette = new Uint32Array(LEVELS);
  let painted = "";
  return (/** @type {Pair} */ range, /** @type {Pair} */ rangeSteps) => {
    const table = tables[model.get("color_map")];
    const asked = `${range} ${model.get("color_map")}`;
    if (asked === painted) return table;
    painted = asked;
    paintDepth(pixels, canvas.width, { table, range, rangeSteps, valid, step }, palette, out);
    context.putImageData(image, 0, 0);
    return table;
  };
}

/**
 * Both histograms; `light` gets the steps of the bar that is chosen in one of them.
 * @param {Element} parent
 * @param {RangeModel} model
 * @param {ReturnType<typeof readDepths>} reading
 * @param {(range: Pair | null) => void} light
 */
function makeCharts(parent, model, { metric_bins, raw_bins, starts }, light) {
  const pair = make("div", "explorer-pair explorer-depth-charts", parent);
  /** @type {(of: number[]) => (bin: number | null) => void} */
  const lightFrom = (of) => (bin) => light(bin === null ? null : [of[bin], of[bin + 1]]);
  /** @type {Pair} */
  const meters = [0, model.get("upper_m")];
  const look = { digits: 1, unit: " m", height: 170 };
  const metric = { ...look, label: "depth (m)", limits: meters };
  /** @type {Pair} */
  const whole = [0, 1];
  const raw = { ...look, label: "raw window depth", limits: whole, digits: 2, unit: "" };
  const charts = [
    makeHistogram(pair, metric_bins, metric, lightFrom(starts.metric)),
    makeHistogram(pair, raw_bins, raw, lightFrom(starts.raw)),
  ];
  return {
    /** @type {(range: Pair, values: RangeCounts, seen: PixelReading) => void} */
    show(range, { share_inside, raw_range, raw_closest }, { pixel_depth, pixel_raw }) {
      charts[0].show(range, pixel_depth);
      charts[1].show(raw_range, pixel_raw);
      charts[0].say(
        `Metric depth: ${share_inside.toFixed(1)} % of the surface pixels are in the range`,
      );
      const rest = `all surfaces lie above ${raw_closest.toFixed(3)}`;
      charts[1].say(`Raw window depth: ${rest}; most of the scale is empty`);
    },
  };
}

/**
 * @param {RangeCounts} values
 * @param {Pair} range
 */
function inWords({ surfaces, left_out, share_inside, raw_range }, [near, far]) {
  const [low, high] = raw_range.map((one) => one.toFixed(4));
  const all = `${surfaces.toLocaleString("en-US")} surface pixels`;
  const held = left_out
    ? `${Math.min(share_inside, 99.9).toFixed(1)} % of the ${all}`
    : `all ${all}`;
  return (
    `${near.toFixed(2)} to ${far.toFixed(2)} m holds ${held}. ` +
    `In the raw buffer: ${low} to ${high}.`
  );
}

/**
 * @param {PixelReading} seen
 * @param {Pixel} pixel
 */
function inPixelWords({ pixel_depth: meters, pixel_raw, pixel_kind }, [u, v]) {
  if (u === undefined) return "";
  if (meters === null || pixel_raw === null || pixel_kind === null)
    return ` Pixel (${u}, ${v}): no depth.`;
  return (
    ` Pixel (${u}, ${v}): ${meters.toFixed(4)} m, ` +
    `raw ${pixel_raw.toFixed(5)}, ${KINDS[pixel_kind]}.`
  );
}

/** @param {PixelReading} seen */
function inShort({ pixel_depth, pixel_kind }) {
  if (pixel_depth === null || pixel_kind === null || pixel_kind === NO_SURFACE) return "no surface";
  const clipped = pixel_kind === INSIDE ? "" : `, ${KINDS[pixel_kind]}`;
  return `${pixel_depth.toFixed(3)} m${clipped}`;
}
