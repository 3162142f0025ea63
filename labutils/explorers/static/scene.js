// The scene as the robot sees it: color and depth, which Python computes while the reader turns the
// head and moves the ball. The same values as SceneView.compute.

import { findKind, LEVELS, paintDepth, readTable, toSteps } from "./_depth_picture.js";
import { defineView, drawOnChange, getContext, make, makeCanvas } from "./_frame.js";
import { makeLookControls } from "./_look_controls.js";
import { makePicker } from "./_picker.js";
import { decodePng, toImageData } from "./_png.js";
import { isSamePose, makeSceneSource, readPose } from "./_scene_source.js";
import { NO_SURFACE } from "./_shared.js";

const PATIENCE_MS = 800; // a Python that is there has answered by then
const STILL = "Press Run to make this scene live.";
const SILENT = "Python does not answer.";
const LIVE = "Live: Python computes every picture.";

export default defineView("scene", start);

/**
 * @param {SceneModel} model
 * @param {Frame} frame
 */
async function start(model, frame) {
  let shown = await readFirst(model);
  const { width, height } = shown;
  const label = "Color: turn the head with the arrow keys or drag";
  const color = makeCanvas(frame.stage, width, height, label);
  color.classList.add("explorer-scene-color");
  makeLookControls(model, color);
  const depth = makeCanvas(frame.side, width, height, "Depth");
  makePicker({ model, frame, canvas: depth, label: "Depth picture: read one pixel" });
  const paint = makePainter(model, color, depth);
  const note = makeNote(frame);
  frame.reserve(inWords({ ...describe(model, shown), pixel_depth: 1 }, [100, 100]));

  const again = drawOnChange(model, frame, () => {
    const values = describe(model, shown);
    frame.tell(inWords(values, model.get("pixel")), values);
  });
  paint(shown);
  const source = makeSceneSource(model, {
    show(came) {
      shown = came;
      paint(shown);
      note.live();
      frame.root.dataset.frames = String(Number(frame.root.dataset.frames ?? 0) + 1);
      again();
    },
    miss: note.miss,
  });
  const names = /** @type {(keyof ScenePose)[]} */ (Object.keys(readPose(model)));
  for (const name of names) model.on(`change:${name}`, source.ask);
  frame.cleanups.push(source.destroy, note.destroy, () => {
    for (const name of names) model.off(`change:${name}`, source.ask);
  });
  source.ask();
}

/**
 * The picture that came with the view.
 * @param {SceneModel} model
 * @returns {Promise<SceneFrame>}
 */
async function readFirst(model) {
  const [rgba, depth] = await Promise.all([
    decodePng(model.get("rgb_png")),
    decodePng(model.get("depth_png")),
  ]);
  const { width, height, data } = rgba;
  const { pixel: _, ...pose } = model.get("start"); // of which this picture is
  const [rgb, steps] = [Uint8Array.from(data), Uint16Array.from(depth.data)];
  return { width, height, rgb, steps, pose, ball_px: model.get("ball_px") };
}

/**
 * Make what paints both pictures.
 * @param {SceneModel} model
 * @param {HTMLCanvasElement} color
 * @param {HTMLCanvasElement} depth
 */
function makePainter(model, color, depth) {
  const { width, height } = color;
  const contexts = [getContext(color), getContext(depth)];
  const image = contexts[1].createImageData(width, height);
  const out = new Uint32Array(image.data.buffer);
  const palette = new Uint32Array(LEVELS);
  const [range, step] = [model.get("colored_m"), model.get("depth_step")];
  const bytes = model.get("color_table");
  const table = readTable(new Uint8Array(bytes.buffer, bytes.byteOffset, bytes.byteLength), 0);
  const valid = model.get("valid_steps");
  const look = { table, range, rangeSteps: toSteps(range, step), valid, step };
  return (/** @type {SceneFrame} */ { rgb, steps }) => {
    contexts[0].putImageData(toImageData({ width, height, channels: 3, data: rgb }), 0, 0);
    paintDepth(steps, width, look, palette, out);
    contexts[1].putImageData(image, 0, 0);
  };
}

/**
 * The line that says whether Python draws; it stands from the start, so that nothing moves.
 * @param {Frame} frame
 */
function makeNote(frame) {
  const line = make("p", "explorer-help explorer-scene-note", frame.foot);
  line.setAttribute("role", "status");
  const timer = setTimeout(() => {
    line.textContent = STILL;
  }, PATIENCE_MS);
  return {
    live() {
      clearTimeout(timer);
      if (line.textContent !== LIVE) line.textContent = LIVE;
    },
    miss() {
      if (line.textContent === LIVE) line.textContent = SILENT;
    },
    destroy: () => clearTimeout(timer),
  };
}

/**
 * What is shown, how far the ball is from the middle, and of the pixel, how far away it is.
 * @param {SceneModel} model
 * @param {SceneFrame} shown
 * @returns {SceneValues}
 */
function describe(model, { pose, steps, width, height, ball_px: [ballU, ballV] }) {
  const [u, v] = model.get("pixel");
  const count = u === undefined ? 0 : steps[v * width + u];
  const valid = model.get("valid_steps");
  const sees = findKind(count, [0, LEVELS], valid) !== NO_SURFACE;
  return {
    ...pose,
    is_current: isSamePose(pose, readPose(model)),
    pixel_depth: sees ? count * model.get("depth_step") : null,
    ball_off_px:
      ballU === undefined ? null : Math.hypot(ballU - (width - 1) / 2, ballV - (height - 1) / 2),
  };
}

/**
 * @param {SceneValues} values
 * @param {Pixel} pixel
 */
function inWords({ pan_deg, tilt_deg, ball_x, ball_y, pixel_depth }, pixel) {
  const depth = pixel_depth === null ? "no surface" : `${pixel_depth.toFixed(3)} m`;
  return (
    `Neck: pan ${pan_deg.toFixed(1)}°, tilt ${tilt_deg.toFixed(1)}°. ` +
    `Ball: x ${ball_x.toFixed(2)} m, y ${ball_y.toFixed(2)} m.` +
    (pixel.length ? ` Depth at pixel (${pixel.join(", ")}): ${depth}.` : "")
  );
}
