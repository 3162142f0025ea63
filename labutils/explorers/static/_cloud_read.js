// From the traits of a view to the cloud that all modules know: see Cloud in _types.d.ts.

import { joinTransforms, STAY } from "./_orbit.js";
import { FROM_WORLD } from "./_shared.js";

/**
 * Gather what never changes: depth in steps, colors, the camera's matrix and pose.
 * @param {CloudModel} model
 * @param {{ data: Uint8ClampedArray }} image
 * @param {Picture} depth
 * @returns {Cloud}
 */
export function readCloud(model, image, depth) {
  const pose = model.get("T_world_cam");
  const worldFromCamera = pose.length ? pose.slice(0, 3).flat() : null;
  const orbitFromBase = worldFromCamera ? FROM_WORLD : STAY;
  const bytes = model.get("palette");
  const palette32 = new Uint32Array(256);
  const palette = new Uint8Array(palette32.buffer); // red, green, blue, opaque, on any machine
  for (let i = 0; i < 256; i++) {
    palette.set(
      [bytes.getUint8(3 * i), bytes.getUint8(3 * i + 1), bytes.getUint8(3 * i + 2), 255],
      4 * i,
    );
  }
  return {
    width: depth.width,
    height: depth.height,
    steps: depth.data,
    depthStep: model.get("depth_step"),
    minDepth: model.get("min_depth"),
    rgba32: new Uint32Array(image.data.buffer),
    palette,
    palette32,
    trueK: model.get("true_K"),
    trueFov: model.get("true_fov_y_deg"),
    worldFromCamera,
    orbitFromBase,
    orbitFromCamera: worldFromCamera ? joinTransforms(orbitFromBase, worldFromCamera) : STAY,
    faces: model.get("faces"),
    depthLimits: model.get("depth_limits"),
    heightLimits: model.get("height_limits"),
  };
}
