// Field of view: one wide picture is enough, because a pinhole camera with a smaller angle sees
// exactly the middle of it. Mirrors labutils.camera_utils.intrinsics_matrix.

import { fovFromFocal, intrinsicsMatrix } from "./_camera.js";
import { defineView, drawOnChange, getContext, make, makeCanvas } from "./_frame.js";
import { decodePng, toImageData } from "./_png.js";
import { describeRay, makeRayPointer } from "./_ray_pointer.js";
import { makeTopView } from "./_top_view.js";

const HINT = "Point at the picture: which ray is it?";

export default defineView("fov", start);

/**
 * @param {FovModel} model
 * @param {Frame} frame
 */
async function start(model, frame) {
  const image = toImageData(await decodePng(model.get("wide_png")));
  const wide = Object.assign(document.createElement("canvas"), image);
  wide.width = image.width;
  wide.height = image.height;
  getContext(wide).putImageData(image, 0, 0);

  const landmarks = model.get("landmarks");
  const canvas = makeCanvas(frame.stage, 640, 480, "What the camera sees");
  const top = makeTopView(frame.side, landmarks);
  const table = makeMatrix(frame.side);
  const longest = { ...describeCamera(20, [1280, 960]), seen: [] };
  frame.reserve(inWords(longest, landmarks, describeRay({ u: 1000, v: 900, right: 20, up: -20 })));
  const pointer = makeRayPointer(canvas, () => later());
  const later = drawOnChange(model, frame, () => {
    const [fov, size] = [model.get("fov_y_deg"), model.get("sizes")[model.get("size")]];
    drawCrop(canvas, wide, fov, model.get("max_fov_deg"), size);
    const camera = describeCamera(fov, size);
    const ray = pointer.show(camera.K, size);
    const seen = top.show(camera.fov_x_deg, ray);
    const values = { ...camera, spare_deg: findSpare(fov, landmarks), seen };
    table.show(values.K);
    frame.tell(inWords(values, landmarks, ray ? describeRay(ray) : HINT), values);
  });
  top.onPoint(pointer.pointAt);
}

/**
 * What the numbers of this camera are; the same as FovView.compute in Python.
 * @param {number} fovYDegrees
 * @param {Pair} size
 */
export function describeCamera(fovYDegrees, [width, height]) {
  const K = intrinsicsMatrix(fovYDegrees, width, height);
  const f = K[0][0];
  return { f, K, fov_x_deg: fovFromFocal(f, width), mm_per_px: 1000 / f };
}

/**
 * Draw the middle of the wide picture, in pixels as large as the camera's.
 * @param {HTMLCanvasElement} canvas
 * @param {HTMLCanvasElement} wide
 * @param {number} fov
 * @param {number} maxFov
 * @param {Pair} size
 */
function drawCrop(canvas, wide, fov, maxFov, [width, height]) {
  /** @param {number} degrees */
  const half = (degrees) => Math.tan((degrees * Math.PI) / 360);
  const share = half(fov) / half(maxFov);
  const [w, h] = [wide.width * share, wide.height * share];
  const [left, top] = [(wide.width - w) / 2, (wide.height - h) / 2];
  const context = getContext(canvas);
  if (width >= canvas.width) {
    context.imageSmoothingEnabled = true;
    context.drawImage(wide, left, top, w, h, 0, 0, canvas.width, canvas.height);
    return;
  }
  // fewer pixels: shrink first, then show each as a square
  context.imageSmoothingEnabled = true;
  context.drawImage(wide, left, top, w, h, 0, 0, width, height);
  context.imageSmoothingEnabled = false;
  context.drawImage(canvas, 0, 0, width, height, 0, 0, canvas.width, canvas.height);
}

/** @param {Element} parent */
function makeMatrix(parent) {
  const table = make("table", "explorer-matrix", parent);
  make("caption", "", table).textContent = "K, in pixels";
  const cells = [0, 1, 2].map(() => {
    const row = make("tr", "", table);
    return [0, 1, 2].map(() => make("td", "", row));
  });
  return {
    /** @param {Matrix} K */
    show(K) {
      for (const [i, row] of K.entries()) {
        for (const [j, value] of row.entries()) {
          cells[i][j].textContent = Number.isInteger(value) ? String(value) : value.toFixed(1);
        }
      }
    },
  };
}

/**
 * How far the angle could close with all things whole; negative where one is cut.
 * @param {number} fov
 * @param {Landmark[]} landmarks
 */
function findSpare(fov, landmarks) {
  let largest = 0;
  for (const { half_tan } of landmarks) {
    if (half_tan === null) return null;
    largest = Math.max(largest, half_tan);
  }
  return landmarks.length ? fov - (2 * Math.atan(largest) * 180) / Math.PI : null;
}

/**
 * @param {{ f: number, fov_x_deg: number, mm_per_px: number, seen: string[] }} values
 * @param {Landmark[]} landmarks
 * @param {string} pointed
 */
function inWords({ f, fov_x_deg, mm_per_px, seen }, landmarks, pointed) {
  const outside = landmarks.map(({ name }) => name).filter((name) => !seen.includes(name));
  const things = outside.length ? `Outside: ${outside.join(", ")}.` : "All objects are inside.";
  return (
    `f = ${f.toFixed(1)} px; ${fov_x_deg.toFixed(1)}° from left to right. ` +
    `At 1 m a pixel covers ${mm_per_px.toFixed(2)} mm. ` +
    (landmarks.length ? `${things} ` : "") +
    pointed
  );
}
