import assert from "node:assert/strict";
import { test } from "node:test";
import * as camera from "../../../labutils/explorers/static/_camera.js";
import { describeCamera } from "../../../labutils/explorers/static/fov.js";
import { assertNear } from "./_near.mjs";

test("90 degrees see as far up as ahead: the focal length is half the height", () => {
  assertNear(camera.focalFromFov(90, 480), 240);
  assertNear(camera.fovFromFocal(240, 480), 90);
});

test("the middle of the picture lies between the pixels of an even size", () => {
  const K = camera.intrinsicsMatrix(90, 640, 480);
  assertNear(K.flat(), [240, 0, 319.5, 0, 240, 239.5, 0, 0, 1]);
});

test("a pixel beside the middle shows a point to the right, one below it a point below", () => {
  const K = camera.intrinsicsMatrix(90, 640, 480);
  assertNear(camera.pixelToPoint(319.5, 239.5, 2, K), [0, 0, 2]);
  assertNear(camera.pixelToPoint(439.5, 359.5, 2, K), [1, 1, 2]);
});

test("at 1 m a pixel covers the inverse of the focal length, in millimeters", () => {
  const { f, mm_per_px, fov_x_deg } = describeCamera(90, [480, 480]);
  assertNear(mm_per_px * f, 1000);
  assertNear(fov_x_deg, 90);
  assert.ok(describeCamera(90, [640, 480]).fov_x_deg > 90);
});
