// What the reader sees: the cloud, and over it the camera's rays and the point that was picked.

import { makeCanvasPainter } from "../../labutils/explorers/static/_cloud_canvas.js";
import { makeGlPainter } from "../../labutils/explorers/static/_cloud_gl.js";
import { makeMarks } from "../../labutils/explorers/static/_cloud_marks.js";
import { joinTransforms, makeEyeTransform } from "../../labutils/explorers/static/_orbit.js";
import { makeSplatBuffer, pickDrawn, splatPoints } from "../../labutils/explorers/static/_splat.js";
import { FAR } from "./scene.js";

/**
 * @param {HTMLElement} stage
 * @param {HeroScene} scene
 */
export function makeView(stage, { cloud }) {
  /** @type {CloudPainter | null} */
  let painter = null;
  const drawMarks = makeMarks(stage, cloud);

  /**
   * Seen from the camera itself the cloud covers the photo, pixel by pixel.
   * @param {Orbit} orbit
   * @param {number} resolution
   * @returns {PageLook}
   */
  function makeLook(orbit, resolution) {
    const [pageWidth, pageHeight] = [stage.clientWidth, stage.clientHeight];
    const [width, height] = [pageWidth, pageHeight].map((one) => Math.round(one * resolution));
    const focal = cloud.trueK[1][1] / cloud.height; // in heights of the picture
    const eyeFromOrbit = makeEyeTransform(orbit);
    return {
      pageWidth,
      pageHeight,
      width,
      height,
      pageFocal: focal * pageHeight,
      focal: focal * height,
      eyeFromOrbit,
      eyeFromCamera: joinTransforms(eyeFromOrbit, cloud.orbitFromCamera),
      K: cloud.trueK,
      far: FAR,
    };
  }

  /** @param {(canvas: HTMLCanvasElement, cloud: Cloud) => CloudPainter | null} makePainter */
  function use(makePainter) {
    const canvas = document.createElement("canvas");
    canvas.className = "hero-points";
    canvas.setAttribute("aria-hidden", "true"); // the stage around it speaks
    const made = makePainter(canvas, cloud);
    if (!made) return false;
    painter?.destroy();
    stage.querySelector(".hero-points")?.remove();
    stage.querySelector("img")?.after(canvas);
    painter = made;
    canvas.addEventListener("webglcontextlost", () => use(makeCanvasPainter), { once: true });
    return true;
  }

  return {
    get kind() {
      return painter?.kind ?? "";
    },
    /** Choose what draws: WebGL, else a plain canvas; tells whether there is either. */
    open() {
      if (painter) return true;
      for (const makePainter of [makeGlPainter, makeCanvasPainter]) {
        try {
          if (use(makePainter)) return true;
        } catch (error) {
          console.warn(error); // a driver that cannot run the program: the canvas can
        }
      }
      return false;
    },
    /**
     * @param {Orbit} orbit
     * @param {Triple | null} point
     * @param {boolean} isLifted
     */
    draw(orbit, point, isLifted) {
      if (!stage.clientWidth) return;
      if (isLifted) painter?.draw(makeLook(orbit, painter.resolution), cloud.rgba32, 1);
      drawMarks(makeLook(orbit, 1), point);
    },
    /**
     * The point at a place of the stage; -1 where there is none.
     * @param {Orbit} orbit
     * @param {number} x
     * @param {number} y
     * @param {number} slack
     */
    pick(orbit, x, y, slack) {
      const look = makeLook(orbit, 1);
      const buffer = makeSplatBuffer(look.width, look.height);
      splatPoints(cloud, look, buffer);
      return pickDrawn(buffer, x, y, slack);
    },
  };
}
