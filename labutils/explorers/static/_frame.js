// What every explorer is made of: a stage for pictures, which stays in view on a phone, and below it
// the goal; a read-out; a side for more drawings; a line of help, Reset.

import { adoptControls } from "./_controls.js";
import { make as makeElement } from "./_elements.js";
import { makeGoal } from "./_goal.js";

const SPEAK_AFTER_MS = 700; // a screen reader hears the value one stops at, not all in between

/**
 * Make a view, as anywidget wants it, of what fills its frame; what goes wrong stands in it.
 * @template {Model<ViewTraits<any>>} M
 * @param {string} name
 * @param {(model: M, frame: Frame) => void | Promise<void>} start
 */
export function defineView(name, start) {
  return {
    async render(/** @type {{ model: M, el: HTMLElement }} */ { model, el }) {
      const frame = makeFrame({ model, el }, name);
      try {
        await start(model, frame);
      } catch (error) {
        frame.fail(error);
      }
      return () => frame.destroy();
    },
  };
}

/**
 * Build the frame of an explorer inside `el`.
 * @param {{ model: Model<ViewTraits<any>>, el: HTMLElement }} place
 * @param {string} name
 * @returns {Frame}
 */
function makeFrame({ model, el }, name) {
  const root = make("div", "explorer", el);
  // where a page finds what a reader has set, see book/_page_python/widgets_carry.js
  Object.assign(root, { explorerModel: model });
  root.dataset.explorer = name;
  root.dataset.state = "loading";
  root.setAttribute("role", "group");
  root.setAttribute("aria-label", model.get("label"));
  const main = make("div", "explorer-main", root);
  const pinned = make("div", "explorer-pinned", main);
  const stage = make("div", "explorer-stage", pinned);
  const goal = makeGoal(pinned, model.get("goal"));
  const told = make("div", "explorer-told", main);
  const readout = make("p", "explorer-readout", told);
  const room = make("p", "explorer-readout-room", told);
  room.setAttribute("aria-hidden", "true");
  const spoken = make("p", "explorer-spoken", root);
  spoken.setAttribute("role", "status");
  const side = make("div", "explorer-side", root);
  const foot = make("div", "explorer-foot", main);
  make("p", "explorer-help", foot).textContent = model.get("help");
  const reset = make("button", "explorer-button", foot);
  reset.type = "button";
  reset.textContent = "Reset";
  reset.addEventListener("click", () => setTraits(model, model.get("start")));
  /** @type {ReturnType<typeof setTimeout>} */
  let timer;
  let heard = ""; // the first value is on the page already: nobody asked to hear it
  /** @type {Record<string, unknown>} */
  let last = {};
  const setGoal = () => {
    goal.set(model.get("goal"));
    goal.show(last);
  };
  model.on("change:goal", setGoal);
  const cleanups = [
    () => clearTimeout(timer),
    adoptControls(el),
    () => model.off("change:goal", setGoal),
  ];
  return {
    root,
    stage,
    side,
    foot,
    cleanups,
    /** Keep as much room for the read-out as its longest text takes, so that nothing jumps. */
    reserve(longest) {
      room.textContent = longest;
    },
    /** Hide the goal for as long as nothing shown can reach it; its place stays. */
    suspendGoal: goal.suspend,
    /** Tell the result: in words, and as values that a test reads. */
    tell(text, values) {
      if (readout.textContent !== text) readout.textContent = text;
      last = { ...values };
      goal.show(last);
      const names = /** @type {(keyof ViewTraits<any>)[]} */ (Object.keys(model.get("start")));
      const parameters = names.map((one) => [one, model.get(one)]);
      root.dataset.parameters = JSON.stringify(Object.fromEntries(parameters));
      root.dataset.values = JSON.stringify(values);
      root.dataset.state = "ready";
      heard ||= text;
      clearTimeout(timer);
      timer = setTimeout(() => {
        if (heard !== text) spoken.textContent = heard = text;
      }, SPEAK_AFTER_MS);
    },
    /** Say why there is no picture. */
    fail(error) {
      root.dataset.state = "failed";
      readout.textContent = `This explorer cannot be drawn: ${toError(error).message}`;
    },
    destroy() {
      for (const cleanup of cleanups) cleanup();
      root.remove();
    },
  };
}

/**
 * Draw now and after every change of a parameter, at most once per frame of the screen. Returns
 * what asks for another drawing.
 * @param {Model<ViewTraits<any>>} model
 * @param {Frame} frame
 * @param {() => void} draw
 */
export function drawOnChange(model, frame, draw) {
  const names = Object.keys(model.get("start"));
  let queued = 0;
  const drawTimed = () => {
    queued = 0;
    const started = performance.now();
    draw();
    frame.root.dataset.drawMs = (performance.now() - started).toFixed(2);
  };
  const later = () => {
    queued ||= requestAnimationFrame(drawTimed);
  };
  for (const one of names) model.on(`change:${one}`, later);
  frame.cleanups.push(() => {
    cancelAnimationFrame(queued);
    for (const one of names) model.off(`change:${one}`, later);
  });
  drawTimed();
  return later;
}

/**
 * Set several traits, and let the kernel know where there is one.
 * @template Traits
 * @param {Model<Traits>} model
 * @param {Partial<Traits>} values
 */
export function setTraits(model, values) {
  for (const name in values) model.set(name, /** @type {any} */ (values[name]));
  model.save_changes();
}

/** Make an element inside another. */
export const make = makeElement;

/**
 * Make a canvas of a size in pixels; it says in words what it shows.
 * @param {Element} parent
 * @param {number} width
 * @param {number} height
 * @param {string} label
 */
export function makeCanvas(parent, width, height, label) {
  const canvas = make("canvas", "explorer-canvas", parent);
  canvas.width = width;
  canvas.height = height;
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", label);
  return canvas;
}

/**
 * Get what draws on a canvas; every browser has it, unless too many are in use.
 * @param {HTMLCanvasElement} canvas
 * @param {CanvasRenderingContext2DSettings} [settings]
 */
export function getContext(canvas, settings) {
  const context = canvas.getContext("2d", settings);
  if (!context) throw new Error("the browser has no canvas left");
  return context;
}

/** What was thrown, as an error: anything can be thrown. */
export function toError(/** @type {unknown} */ thrown) {
  return thrown instanceof Error ? thrown : new Error(String(thrown));
}
