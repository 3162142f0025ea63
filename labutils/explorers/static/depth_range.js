// Depth range: which depths get the colors, and where they lie in the raw buffer.

import { metricToRaw } from "./_depth.js";
import {
  binMetric,
  binRaw,
  countKinds,
  countSteps,
  findKind,
  findStripe,
  LEVELS,
  paintDepth,
  readTable,
  toSteps,
} from "./_depth_picture.js";
import { defineView, drawOnChange, getContext, make, makeCanvas } from "./_frame.js";
import { makePicker } from "./_picker.js";
import { makePlot } from "./_plot.js";
import { decodePng } from "./_png.js";
import { addShape, setShape } from "./_shapes.js";
import { FARTHER, INSIDE, NEARER, NO_SURFACE } from "./_shared.js";

const BINS = 50;

export default defineView("depth-range", start);

/**
 * @param {RangeModel} model
 * @param {Frame} frame
 */
async function start(model, frame) {
  const { width, height, data: pixels } = await decodePng(model.get("depth_png"));
  const step = model.get("depth_step");
  const clip = model.get("clip_m");
  const upper = model.get("upper_m");
  const valid = toSteps(model.get("valid_m"), step);
  const bytes = model.get("color_tables");
  const all = new Uint8Array(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const tables = model.get("color_names").map((_, place) => readTable(all, place * 768));

  const counts = countSteps(pixels);
  const bins = [
    binMetric(counts, BINS, upper, step, valid),
    binRaw(counts, BINS, step, valid, clip),
  ];
  const closest =
    step * counts.findIndex((n, steps) => n > 0 && steps > valid[0] && steps < valid[1]);

  const canvas = makeCanvas(frame.stage, width, height, "Depth");
  makePicker({ model, frame, canvas, label: "Depth image: read one pixel" });
  const context = getContext(canvas);
  const image = context.createImageData(width, height);
  const out = new Uint32Array(image.data.buffer);
  const palette = new Uint32Array(LEVELS);
  const bar = makeColorBar(frame.stage);
  const pair = make("div", "explorer-pair", frame.stage);
  const charts = [
    makeHistogram(pair, bins[0], "depth (m)", [0, upper]),
    makeHistogram(pair, bins[1], "raw window depth", [0, 1]),
  ];

  /** @type {(limits: Pair) => Pair} */
  const toRaw = ([low, high]) => [metricToRaw(low, ...clip), metricToRaw(high, ...clip)];
  drawOnChange(model, frame, () => {
    const range = model.get("range_m");
    const rangeSteps = toSteps(range, step);
    const table = tables[model.get("color_map")];
    paintDepth(pixels, width, { table, range, rangeSteps, valid, step }, palette, out);
    context.putImageData(image, 0, 0);
    bar.show(table, range);

    const [u, v] = model.get("pixel");
    const steps = u === undefined ? 0 : pixels[v * width + u];
    const kinds = countKinds(counts, rangeSteps, valid);
    const depth = steps ? steps * step : null;
    const values = {
      share_nearer: (100 * kinds[NEARER]) / pixels.length,
      share_inside: (100 * kinds[INSIDE]) / pixels.length,
      share_farther: (100 * kinds[FARTHER]) / pixels.length,
      no_surface: kinds[NO_SURFACE],
      raw_range: toRaw(range),
      raw_closest: metricToRaw(closest, ...clip),
      metric_bins: bins[0],
      raw_bins: bins[1],
      pixel_depth: depth,
      pixel_raw: depth === null ? null : metricToRaw(depth, ...clip),
      pixel_kind: u === undefined ? null : findKind(steps, rangeSteps, valid),
    };
    charts[0].show(range, depth);
    charts[1].show(values.raw_range, values.pixel_raw);
    const rest = `all surfaces lie above ${values.raw_closest.toFixed(3)}`;
    charts[0].say(
      `Metric depth: ${values.share_inside.toFixed(1)} % of the pixels are in the range`,
    );
    charts[1].say(`Raw window depth: ${rest}; most of the scale is empty`);
    frame.tell(inWords(values, range, [u, v]), values);
  });
}

/**
 * What the colors mean: a bar from near to far in meters, and the three that are no distance.
 * @param {Element} parent
 */
function makeColorBar(parent) {
  const holder = make("div", "explorer-colorbar", parent);
  const canvas = makeCanvas(holder, 256, 1, "Color bar");
  const context = getContext(canvas);
  const image = context.createImageData(256, 1);
  const colors = new Uint32Array(image.data.buffer);
  const scale = make("div", "explorer-colorbar-scale", holder);
  const ends = [0, 1, 2].map(() => make("span", "", scale));
  const key = make("div", "explorer-key", holder);
  const named = new Map([
    [NEARER, "nearer"],
    [FARTHER, "farther"],
    [NO_SURFACE, "no surface"],
  ]);
  for (const [kind, name] of named) {
    const item = make("span", "explorer-key-item", key);
    drawSwatch(item, kind);
    item.append(name);
  }
  return {
    /**
     * @param {Uint32Array} table
     * @param {Pair} range
     */
    show(table, [near, far]) {
      colors.set(table);
      context.putImageData(image, 0, 0);
      [near, (near + far) / 2, far].forEach((meters, place) => {
        ends[place].textContent = `${meters.toFixed(2)} m`;
      });
      canvas.setAttribute(
        "aria-label",
        `Color bar from ${near.toFixed(2)} m to ${far.toFixed(2)} m`,
      );
    },
  };
}

/**
 * @param {Element} parent
 * @param {number} kind
 */
function drawSwatch(parent, kind) {
  const canvas = make("canvas", "explorer-swatch", parent);
  [canvas.width, canvas.height] = [32, 32];
  canvas.setAttribute("aria-hidden", "true");
  const context = getContext(canvas);
  const image = context.createImageData(32, 32);
  const out = new Uint32Array(image.data.buffer);
  for (let i = 0; i < out.length; i++) {
    out[i] = kind === NO_SURFACE ? 0xff000000 : findStripe(kind, i % 32, i >> 5);
  }
  context.putImageData(image, 0, 0);
}

/**
 * Bars that stay, a band that follows the range, and a line for the pixel.
 * @param {Element} parent
 * @param {number[]} counts
 * @param {string} label
 * @param {Pair} limits
 */
function makeHistogram(parent, counts, label, limits) {
  const total = counts.reduce((sum, one) => sum + one, 0) || 1;
  const highest = (100 * Math.max(...counts)) / total || 1;
  const plot = makePlot(parent, {
    x: { label },
    y: { label: "% of the surface pixels" },
    height: 190,
  });
  plot.setLimits(limits, [0, highest]);
  const { area, inside } = plot;
  const band = addShape(inside, "rect", { class: "explorer-band", y: area.top });
  setShape(band, { height: area.bottom - area.top });
  const places = counts.map((count, i) => {
    const from = plot.x((limits[1] * i) / counts.length);
    const to = plot.x((limits[1] * (i + 1)) / counts.length);
    return `M${from} ${area.bottom}V${plot.y((100 * count) / total)}H${to}V${area.bottom}Z`;
  });
  addShape(inside, "path", { class: "explorer-bars", d: places.join("") });
  const edges = addShape(plot.above, "path", { class: "explorer-edges" });
  const mark = addShape(plot.above, "path", { class: "explorer-pixel-line" });
  const clamp = (/** @type {number} */ value) => Math.min(limits[1], Math.max(limits[0], value));
  return {
    /** @type {(range: Pair, value: number | null) => void} */
    show([low, high], value) {
      const [from, to] = [plot.x(clamp(low)), plot.x(clamp(high))];
      setShape(band, { x: from, width: Math.max(to - from, 0) });
      setShape(edges, {
        d: `M${from} ${area.top}V${area.bottom}M${to} ${area.top}V${area.bottom}`,
      });
      const at = value === null ? "" : plot.x(clamp(value)).toFixed(2);
      setShape(mark, { d: at && `M${at} ${area.bottom}V${area.top}m0 0l-5 -8h10Z` });
    },
    say: (/** @type {string} */ text) => plot.svg.setAttribute("aria-label", text),
  };
}

/**
 * @param {RangeValues} values
 * @param {Pair} range
 * @param {Pixel} pixel
 */
function inWords(values, [near, far], [u, v]) {
  const [low, high] = values.raw_range.map((one) => one.toFixed(4));
  const text =
    `${near.toFixed(2)} to ${far.toFixed(2)} m holds ${values.share_inside.toFixed(1)} % of the pixels; ` +
    `${values.no_surface.toLocaleString("en-US")} see no surface. The same range in the raw buffer: ${low} to ${high}.`;
  if (u === undefined) return text;
  const { pixel_depth: meters, pixel_raw, pixel_kind } = values;
  if (meters === null || pixel_raw === null || pixel_kind === null) {
    return `${text} Pixel (${u}, ${v}): no depth.`;
  }
  const kind = ["nearer than the range", "in the range", "farther than the range", "no surface"];
  return (
    `${text} Pixel (${u}, ${v}): ${meters.toFixed(4)} m = ${(1000 * meters).toFixed(1)} mm, ` +
    `raw ${pixel_raw.toFixed(5)}, ${kind[pixel_kind]}.`
  );
}
