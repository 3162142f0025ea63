// What a reader can do on the first screen: lift the photo, walk around, read a point, go back.

import { makeOrbitControls } from "../../labutils/explorers/static/_orbit_controls.js";
import { makeFlights, mixOrbits } from "./flight.js";
import { findMiddle, findPoint, inWords, readPoint, readScene } from "./scene.js";
import { makeView } from "./view.js";

const BALL = "red ball";
const STEP_BACK = 1.25; // as the photo lifts: the cloud is wider than what the camera sees
/** Where the button leads to, from where the camera is. */
const LIFT = { azimuth_deg: 38, elevation_deg: -6 };
const SKY = "The sky: nothing sends a depth back, so there is no point to measure.";
const EMPTY = "No point there: nothing in that place was in the camera's sight.";
const NO_CLOUD = "This browser can draw no cloud; the photo stays.";

/**
 * @param {HeroElement} figure
 * @param {HTMLElement} stage
 * @param {HeroData} data
 * @param {(text: string) => void} tell
 * @returns {Promise<HeroActions>}
 */
export async function startHero(figure, stage, data, tell) {
  const scene = await readScene(data);
  const view = makeView(stage, scene);
  const flights = makeFlights();
  const isLifted = () => figure.dataset.state === "lifted";
  let picked = -1;
  let queued = 0;

  function draw() {
    if (queued) return;
    queued = requestAnimationFrame(() => {
      queued = 0;
      const point = picked < 0 ? null : findPoint(scene.cloud, picked);
      view.draw(model.get("orbit"), point, isLifted());
      figure.dataset.painter = view.kind;
    });
  }

  /** Every change of the place lifts the photo: the cloud goes on where it hung. */
  const model = makeModel(scene.start, () => {
    if (view.open()) figure.dataset.state = "lifted";
    else tell(NO_CLOUD);
    draw();
  });

  function read(/** @type {number} */ id) {
    picked = scene.cloud.steps[id] ? id : -1;
    if (picked >= 0) tell(inWords(readPoint(scene, picked)));
    else tell(isLifted() ? EMPTY : SKY);
    draw();
  }

  const turned = stepBackWhenLifted(model, flights, isLifted);
  const pick = (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ slack) =>
    read(view.pick(model.get("orbit"), x, y, slack));
  const frame = /** @type {Frame} */ (/** @type {unknown} */ ({ cleanups: [] }));
  const actions = {
    lift() {
      const to = {
        ...scene.start,
        azimuth_deg: scene.start.azimuth_deg + LIFT.azimuth_deg,
        elevation_deg: scene.start.elevation_deg + LIFT.elevation_deg,
        distance: scene.start.distance * STEP_BACK,
      };
      flyTo(model, flights, to);
    },
    ball: () => read(findMiddle(scene, BALL)),
    reset() {
      if (!isLifted()) return;
      flyTo(model, flights, scene.start, () => {
        figure.dataset.state = "flat";
        draw();
      });
    },
  };
  takeOver(stage, flights, actions);
  makeOrbitControls({ model: turned, frame, surface: stage, pick });
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

/**
 * The same for a reader's hand: with its first move one steps back, while it goes on turning.
 * @param {OrbitModel} model
 * @param {Flights} flights
 * @param {() => boolean} isLifted
 * @returns {OrbitModel}
 */
function stepBackWhenLifted(model, flights, isLifted) {
  function stepBack() {
    let before = 1;
    flights.fly((share) => {
      const now = 1 + share * (STEP_BACK - 1);
      const orbit = model.get("orbit");
      model.set("orbit", { ...orbit, distance: (orbit.distance * now) / before });
      before = now;
    });
  }
  return {
    ...model,
    set(name, value) {
      const wasFlat = !isLifted();
      model.set(name, value);
      if (wasFlat && isLifted()) stepBack();
    },
  };
}

/**
 * @param {OrbitModel} model
 * @param {Flights} flights
 * @param {Orbit} to
 * @param {() => void} [land]
 */
function flyTo(model, flights, to, land) {
  const from = model.get("orbit");
  flights.fly((share) => model.set("orbit", mixOrbits(from, to, share)), land);
}

/**
 * A hand on the stage ends what moves by itself; Home leads back to the photo.
 * @param {HTMLElement} stage
 * @param {Flights} flights
 * @param {HeroActions} actions
 */
function takeOver(stage, flights, actions) {
  stage.addEventListener("pointerdown", flights.stop, { capture: true });
  stage.addEventListener(
    "keydown",
    (event) => {
      flights.stop();
      if (event.key !== "Home") return;
      event.preventDefault();
      event.stopPropagation(); // the controls would be there at once, and lifted
      actions.reset();
    },
    { capture: true },
  );
}
