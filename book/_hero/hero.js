// The first screen of the book: the head camera's photo, which lifts into a cloud at the first drag.
// A click on it reads how far away a point is. Without this script the photo stands there.

import { startHero } from "./actions.js";

const DATA = "hero_data.js";
const script = /** @type {HTMLScriptElement} */ (document.currentScript);

document.addEventListener("DOMContentLoaded", () => {
  const figure = /** @type {HeroElement | null} */ (document.querySelector("figure.hero"));
  if (figure) prepare(figure);
});

/** Load the data while nobody waits, or as soon as somebody does. */
function prepare(/** @type {HeroElement} */ figure) {
  const stage = makeStage(figure);
  const line = figure.querySelector(".hero-reading");
  const tell = (/** @type {string} */ text) => {
    if (line) line.textContent = text;
  };
  /** @type {Promise<HeroActions> | undefined} */
  let started;
  const begin = () => {
    if (!started) {
      started = loadData().then((data) => startHero(figure, stage, data, tell));
      started.catch(() => tell("The cloud could not be loaded; the photo stays."));
    }
    return started;
  };
  for (const button of figure.querySelectorAll("button")) {
    button.addEventListener("click", async () => {
      const actions = await begin();
      actions[/** @type {keyof HeroActions} */ (button.value)]();
    });
  }
  for (const gesture of ["pointerenter", "focusin", "touchstart"]) {
    figure.addEventListener(gesture, begin, { once: true, passive: true });
  }
  const whenIdle = window.requestIdleCallback ?? setTimeout;
  window.addEventListener("load", () => whenIdle(begin), { once: true });
}

/** @returns {Promise<HeroData>} */
function loadData() {
  const element = document.createElement("script");
  element.src = new URL(DATA, script.src).href;
  return new Promise((resolve, reject) => {
    element.onload = () => {
      const { heroData } = window.cameraLab;
      if (heroData) resolve(heroData);
      else reject(new Error(`${DATA}: expected the data of the first screen, got none`));
    };
    element.onerror = () => reject(new Error(`${DATA} could not be loaded`));
    document.head.append(element);
  });
}

/** Put the photo into the element that takes drags and keys. */
function makeStage(/** @type {HTMLElement} */ figure) {
  const image = /** @type {HTMLImageElement} */ (figure.querySelector("img"));
  const stage = document.createElement("div");
  stage.className = "hero-stage";
  stage.setAttribute(
    "aria-label",
    "The robot's photo in 3-D. Arrow keys walk around, plus and minus zoom, Home returns to the photo",
  );
  image.replaceWith(stage);
  image.draggable = false;
  stage.append(image);
  return stage;
}
