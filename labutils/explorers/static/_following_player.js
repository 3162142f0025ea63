// What the buttons do: Python's next step where it answers, the next moment of a recording where it
// does not.

import { makeFollowingSource } from "./_following_source.js";
import { findPlace, LAST } from "./_following_tape.js";
import { setTraits } from "./_frame.js";

/**
 * Make the player of a run.
 * @param {FollowingModel} model
 * @param {FollowingFrame[]} frames where the moments are kept
 * @param {object} listener
 * @param {() => void} listener.draw something has changed
 * @param {(eye: FollowingBytes, outside: FollowingBytes) => void} listener.begin nothing has
 *   happened yet: what is seen at first
 * @param {(problem: FollowingProblem) => void} listener.fail
 */
export function makePlayer(model, frames, { draw, begin, fail }) {
  const stepMs = 1000 * model.get("dt");
  let [isLive, isRunning, isLost, wantsHiding, wantsRestart] = [false, false, false, false, false];
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  let asked = 0;
  const source = makeFollowingSource(model, {
    hear(answer, buffers) {
      if (answer.kind === "ready") {
        frames.length = 0;
        if (model.get("moment") !== LAST) setTraits(model, { moment: LAST });
        begin(buffers[0], buffers[1]);
      } else if (answer.problem) {
        isRunning = false;
        fail(answer.problem);
      } else if (answer.moment) {
        frames.push({ moment: answer.moment, eye: buffers[0], outside: buffers[1] ?? null });
        player.answerMs = performance.now() - asked;
      } else return;
      [isLive, isLost] = [true, false];
      later();
      draw();
    },
    miss() {
      [isRunning, isLost] = [false, isLive];
      draw();
    },
  });

  /** Go on, as fast as the ball does and no faster. */
  function later() {
    clearTimeout(timer);
    if (wantsRestart) next();
    else if (isRunning) timer = setTimeout(next, Math.max(0, stepMs - (performance.now() - asked)));
  }

  function next() {
    if (!isLive) return playOn();
    const settings = { hide: wantsHiding };
    if (wantsRestart ? !source.ask("restart") : !source.ask("step", settings)) return;
    asked = performance.now();
    if (!wantsRestart) wantsHiding = false;
    wantsRestart = false;
  }

  function playOn() {
    const place = findPlace(model.get("moment"), frames.length);
    asked = performance.now();
    if (place + 1 < frames.length) setTraits(model, { moment: place + 1 });
    if (place + 2 >= frames.length) {
      isRunning = false;
      draw();
    }
    later();
  }

  /** Let the newest moment be shown, or the first one of a recording that has ended. */
  function follow() {
    const isAtEnd = findPlace(model.get("moment"), frames.length) >= frames.length - 1;
    if (isLive) setTraits(model, { moment: LAST });
    else if (isAtEnd) setTraits(model, { moment: 0 });
  }

  const player = {
    answerMs: Number.NaN, // from the last question to its answer
    get isLive() {
      return isLive;
    },
    get isRunning() {
      return isRunning;
    },
    get isLost() {
      return isLost;
    },
    toggle() {
      isRunning = !isRunning;
      if (isRunning) {
        follow();
        next();
      }
      draw();
    },
    step() {
      isRunning = false;
      follow();
      next();
      draw();
    },
    restart() {
      if (isLive) {
        wantsRestart = true;
        next();
      } else setTraits(model, { moment: 0 });
    },
    hide() {
      wantsHiding = true;
      if (!isRunning) player.toggle();
    },
    pause() {
      isRunning = false;
      draw();
    },
    destroy() {
      clearTimeout(timer);
      source.destroy();
    },
  };
  source.ask("hello");
  return player;
}
