// A histogram whose bins can be chosen: with the pointer over them, or with the arrow keys.

import { watchBins } from "./_bins.js";
import { makePlot } from "./_plot.js";
import { addShape, setShape } from "./_shapes.js";

/**
 * Bars that stay, a band that follows the range, a line for the pixel, and a frame around the bin
 * that is chosen. `choose` hears which one is, null for none.
 * @param {Element} parent
 * @param {number[]} counts
 * @param {{ label: string, limits: Pair, digits: number, unit: string, height: number }} options
 * @param {(bin: number | null) => void} choose
 */
export function makeHistogram(parent, counts, { label, limits, digits, unit, height }, choose) {
  const total = counts.reduce((sum, one) => sum + one, 0) || 1;
  const highest = (100 * Math.max(...counts)) / total || 1;
  const plot = makePlot(parent, {
    x: { label },
    y: { label: "% of the surface pixels" },
    height,
  });
  plot.setLimits(limits, [0, highest]);
  const { area, inside } = plot;
  const band = addShape(inside, "rect", { class: "explorer-band", y: area.top });
  setShape(band, { height: area.bottom - area.top });
  const places = counts.map((n, i) => {
    const [left, right] = [i, i + 1].map((end) => toValue(end, counts.length, limits));
    const top = plot.y((100 * n) / total);
    return n ? `M${plot.x(left)} ${area.bottom}V${top}H${plot.x(right)}V${area.bottom}Z` : "";
  });
  addShape(inside, "path", { class: "explorer-bars", d: places.join("") });
  const edges = addShape(plot.above, "path", { class: "explorer-edges" });
  const mark = addShape(plot.above, "path", { class: "explorer-pixel-line" });
  const hovered = addShape(inside, "rect", { class: "explorer-hovered", y: area.top, width: 0 });
  setShape(hovered, { height: area.bottom - area.top });
  const note = addShape(plot.above, "text", { class: "halo", y: area.top + 14 });
  const first = counts.indexOf(Math.max(...counts));
  watchBins(plot, { bins: counts.length, first, name: "histogram", describe }, show);
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

  /** @param {number | null} bin */
  function show(bin) {
    const [left, right] = [bin ?? 0, (bin ?? 0) + 1].map((end) =>
      plot.x(toValue(end, counts.length, limits)),
    );
    setShape(hovered, { x: left, width: bin === null ? 0 : right - left });
    const onLeft = left > (area.left + area.right) / 2;
    setShape(note, { x: onLeft ? left - 6 : right + 6, "text-anchor": onLeft ? "end" : "start" });
    note.textContent = bin === null ? "" : describe(bin);
    choose(bin);
  }

  /** @param {number} bin */
  function describe(bin) {
    const [low, high] = [bin, bin + 1].map((end) =>
      toValue(end, counts.length, limits).toFixed(digits),
    );
    return `${low} to ${high}${unit}: ${((100 * counts[bin]) / total).toFixed(1)} %`;
  }
}

/**
 * The value at which a bin begins.
 * @param {number} bin
 * @param {number} bins
 * @param {Pair} limits
 */
function toValue(bin, bins, [low, high]) {
  return low + ((high - low) * bin) / bins;
}
