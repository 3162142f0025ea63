// Errors over time, the bound they are to keep below, and when the ball was hidden.

import { findHidden } from "./_following_tape.js";
import { makePlot } from "./_plot.js";
import { addShape, setShape } from "./_shapes.js";

const WINDOW_S = 6; // how much is seen at once
const LEAP_S = 2; // how far the window moves, so that it does not run with every step
const ROOM = 5; // the height of the plot, in bounds

/**
 * From when to when a window reaches in which a time can be seen.
 * @param {number} time
 * @returns {Pair}
 */
export function findWindow(time) {
  const start = Math.max(0, Math.ceil((time - WINDOW_S) / LEAP_S - 1e-9)) * LEAP_S;
  return [start, start + WINDOW_S];
}

/**
 * The path of a curve through points; it is broken where a value is not known.
 * @param {(Pair | null)[]} points
 */
export function toBrokenPath(points) {
  let isBroken = true;
  return points
    .map((point) => {
      if (!point) {
        isBroken = true;
        return "";
      }
      const letter = isBroken ? "M" : "L";
      isBroken = false;
      return `${letter}${point[0].toFixed(1)} ${point[1].toFixed(1)}`;
    })
    .join("");
}

/**
 * Make the plot of one error.
 * @param {Element} parent
 * @param {object} options
 * @param {"error_px" | "error_mm"} options.name
 * @param {string} options.label
 * @param {string} options.unit
 * @param {string} options.missing why there is nothing to be seen
 * @param {number} options.bound
 */
export function makeErrorPlot(parent, { name, label, unit, missing, bound }) {
  const [x, y] = [{ label: "time (s)" }, { label: `${label}, dashed: ${bound}` }];
  const plot = makePlot(parent, { height: 200, left: 38, x, y });
  const { area, inside, above } = plot;
  const tall = { y: area.top, height: area.bottom - area.top };
  const hidden = addShape(inside, "g");
  const limit = addShape(inside, "path", { class: "explorer-rival dashed" });
  const curve = addShape(inside, "path", { class: "explorer-curve" });
  const now = addShape(inside, "path", { class: "explorer-pixel-line" });
  const middle = { x: (area.left + area.right) / 2, y: (area.top + area.bottom) / 2 };
  const note = addShape(above, "text", { class: "soft", "text-anchor": "middle", ...middle });
  return {
    /**
     * @param {FollowingFrame[]} frames
     * @param {number} place
     * @param {number} dt
     */
    show(frames, place, dt) {
      const time = place < 0 ? 0 : frames[place].moment.time;
      const window = findWindow(time);
      plot.setLimits(window, [0, ROOM * bound]);
      const [from, to] = window.map((one) => Math.round(one / dt));
      const seen = frames.slice(from, Math.min(place, to) + 1);
      setShape(curve, {
        d: toBrokenPath(
          seen.map(({ moment }) => {
            const value = moment[name];
            return value === null ? null : [plot.x(moment.time), plot.y(value)];
          }),
        ),
      });
      setShape(limit, { d: `M${area.left} ${plot.y(bound)}H${area.right}` });
      const isMissing = seen.length > 0 && seen.every(({ moment }) => moment[name] === null);
      note.textContent = isMissing ? missing : "";
      setShape(now, { d: `M${plot.x(time)} ${area.top}V${area.bottom}` });
      const spans = findHidden(seen, dt).map(([start, end]) => [plot.x(start), plot.x(end)]);
      hidden.replaceChildren();
      for (const [start, end] of spans) {
        addShape(hidden, "rect", { class: "explorer-band", ...tall, x: start, width: end - start });
      }
      const value = place < 0 ? null : frames[place].moment[name];
      const told = value === null ? "unknown" : `${value.toFixed(1)} ${unit}`;
      const words = `${label} over time: ${told} at ${time.toFixed(2)} s, bound ${bound} ${unit}`;
      setShape(plot.svg, { "aria-label": words });
    },
  };
}
