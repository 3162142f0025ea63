// The first screen of the book: the head camera's photo, which lifts into a cloud at the first drag.
// A click on it reads how far away a point is. Without this script the photo stands there.

import { makeOrbitControls } from "../../labutils/explorers/static/_orbit_controls.js";
import { makeFlights, mixOrbits } from "./flight.js";
import { findMiddle, findPoint, inWords, readPoint, readScene } from "./scene.js";
import { makeView } from "./view.js";

const BALL = "red ball";
const SKY = "The sky: nothing sends a depth back, so there is no point to measure.";
const EMPTY = "No point there: nothing in that place was in the camera's sight.";
const STEP_BACK = 1.25; // as the photo lifts: the cloud is wider than what the camera sees
/** Where the button leads to, from where the camera is. */
const LIFT = { azimuth_deg: 38, elevation_deg: -6 };
const DATA = /** @type {HTMLScriptElement} */ (document.currentScript).src.replace(
  /hero\.js/,
  "hero_data.js",
);

document.addEventListener("DOMContentLoaded", () => {
  const figure = /** @type {HeroElement | null} */ (document.querySelector("figure.hero"));
  if (figure) prepare(figure);
});

/** Load the data while nobody waits, or as soon as somebody does. */
function prepare(/** @type {HeroElement} */ figure) {
  const stage = makeStage(figure);
  const buttons = [...figure.querySelectorAll("button")];
  const tell = makeTeller(figure);
  /** @type {Promise<HeroActions> | undefined} */
  let started;
  const begin = () => {
    started ??= loadData().then((data) => start(figure, stage, data, tell));
    started.catch(() => tell("The cloud could not be loaded; the photo stays."));
    return started;
  };
  for (const button of buttons) {
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
  const script = document.createElement("script");
  script.src = DATA;
  return new Promise((resolve, reject) => {
    script.onload = () => {
      const { heroData } = window.cameraLab;
      if (heroData) resolve(heroData);
      else reject(new Error(`${DATA} holds no data`));
    };
    script.onerror = () => reject(new Error(`${DATA} could not be loaded`));
    document.head.append(script);
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
  const shown = image.closest("a") ?? image;
  shown.replaceWith(stage);
  image.draggable = false;
  stage.append(image);
  return stage;
}

function makeTeller(/** @type {HTMLElement} */ figure) {
  const line = figure.querySelector(".hero-reading");
  return (/** @type {string} */ text) => {
    if (line) line.textContent = text;
  };
}

/**
 * @param {HeroElement} figure
 * @param {HTMLElement} stage
 * @param {HeroData} data
 * @param {(text: string) => void} tell
 * @returns {Promise<HeroActions>}
 */
async function start(figure, stage, data, tell) {
  const scene = await readScene(data);
  const { fly, stop } = makeFlights();
  const view = makeView(stage, scene);
  let picked = -1;
  let queued = 0;
  const draw = () => {
    if (queued) return;
    queued = requestAnimationFrame(() => {
      queued = 0;
      const isLifted = figure.dataset.state === "lifted";
      view.draw(model.get("orbit"), picked < 0 ? null : findPoint(scene.cloud, picked), isLifted);
      figure.dataset.painter = view.kind;
    });
  };
  const model = makeModel(scene.start, () => {
    if (figure.dataset.state !== "lifted") lift();
    draw();
  });

  /** The cloud takes the photo's place, from where the camera stands. */
  function lift() {
    if (!view.open()) {
      tell("This browser can draw no cloud; the photo stays.");
      return;
    }
    figure.dataset.state = "lifted";
  }

  /** Step back while the reader turns: the cloud is wider than the photo. */
  function stepBack() {
    let before = 1;
    fly((share) => {
      const now = 1 + share * (STEP_BACK - 1);
      const orbit = model.get("orbit");
      model.set("orbit", { ...orbit, distance: (orbit.distance * now) / before });
      before = now;
    });
  }

  function read(/** @type {number} */ id) {
    picked = scene.cloud.steps[id] ? id : -1;
    const isSky = picked < 0 && figure.dataset.state !== "lifted";
    tell(picked < 0 ? (isSky ? SKY : EMPTY) : inWords(readPoint(scene, picked)));
    draw();
  }

  /** @type {HeroActions} */
  const actions = {
    lift() {
      const from = model.get("orbit");
      const { azimuth_deg, elevation_deg, distance, target } = scene.start;
      const to = {
        azimuth_deg: azimuth_deg + LIFT.azimuth_deg,
        elevation_deg: elevation_deg + LIFT.elevation_deg,
        distance: distance * STEP_BACK,
        target,
      };
      fly((share) => model.set("orbit", mixOrbits(from, to, share)));
    },
    ball() {
      read(findMiddle(scene, BALL));
    },
    reset() {
      if (figure.dataset.state !== "lifted") return;
      const from = model.get("orbit");
      fly(
        (share) => model.set("orbit", mixOrbits(from, scene.start, share)),
        () => {
          figure.dataset.state = "flat";
          draw();
        },
      );
    },
  };

  stage.addEventListener("pointerdown", stop, { capture: true });
  stage.addEventListener(
    "keydown",
    (event) => {
      stop();
      if (event.key !== "Home") return;
      event.preventDefault();
      event.stopPropagation(); // the controls would be there at once
      actions.reset();
    },
    { capture: true },
  );
  const frame = /** @type {Frame} */ (/** @type {unknown} */ ({ cleanups: [] }));
  makeOrbitControls({
    model: {
      ...model,
      set(name, value) {
        const wasFlat = figure.dataset.state !== "lifted";
        model.set(name, value);
        if (wasFlat) stepBack();
      },
    },
    frame,
    surface: stage,
    pick: (x, y, slack) => read(view.pick(model.get("orbit"), x, y, slack)),
  });
  new ResizeObserver(draw).observe(stage);
  figure.heroModel = model;
  figure.dataset.state = "flat";
  return actions;
}

/**
 * What the controls of the explorers turn: here nobody else listens.
 * @param {Orbit} start
 * @param {() => void} onChange
 * @returns {OrbitModel}
 */
function makeModel(start, onChange) {
  const traits = { orbit: start, start: { orbit: start } };
  return {
    get: (name) => traits[name],
    set(name, value) {
      traits[name] = value;
      onChange();
    },
    on() {},
    off() {},
    save_changes() {},
  };
}
