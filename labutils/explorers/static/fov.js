// Field of view: one wide picture is enough, because a pinhole camera with a smaller angle sees
// exactly the middle of it. Mirrors labutils.camera_utils.intrinsics_matrix.

import { fovFromFocal, intrinsicsMatrix } from "./_camera.js";
import { defineView, drawOnChange, getContext, make, makeCanvas } from "./_frame.js";
import { decodePng, toImageData } from "./_png.js";
import { drawTopView, makeTopView } from "./_top_view.js";

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

  const canvas = makeCanvas(frame.stage, 640, 480, "What the camera sees");
  const top = makeTopView(frame.side);
  const table = makeMatrix(frame.side);
  drawOnChange(model, frame, () => {
    const [fov, size] = [model.get("fov_y_deg"), model.get("sizes")[model.get("size")]];
    drawCrop(canvas, wide, fov, model.get("max_fov_deg"), size);
    const camera = describeCamera(fov, size);
    const seen = drawTopView(top, camera.fov_x_deg, model.get("landmarks"));
    const values = { ...camera, seen };
    table.show(values.K);
    frame.tell(inWords(values, model.get("landmarks").length > 0), values);
  });
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
 * @param {{ f: number, fov_x_deg: number, mm_per_px: number, seen: string[] }} values
 * @param {boolean} isMarked
 */
function inWords({ f, fov_x_deg, mm_per_px, seen }, isMarked) {
  const things = seen.length ? seen.join(", ") : "none of the objects";
  return (
    `f = ${f.toFixed(1)} px; ${fov_x_deg.toFixed(1)}° from left to right. ` +
    `At 1 m a pixel covers ${mm_per_px.toFixed(2)} mm.` +
    (isMarked ? ` Inside, from left to right: ${things}.` : "")
  );
}
