// The following loop as the reader's own controller runs it: what the robot sees, what it looks like
// from outside, how far off it is, and where the time goes. The same values as FollowingView.compute.

import { makeBudget } from "./_following_budget.js";
import { makeErrorPlot } from "./_following_curves.js";
import { makeMarks, makePicture } from "./_following_pictures.js";
import { makePlayer } from "./_following_player.js";
import {
  describeBudget,
  describeRun,
  findPicture,
  findPlace,
  readRecording,
} from "./_following_tape.js";
import { defineView, drawOnChange, make, setTraits } from "./_frame.js";

const LIVE = "Live: Python runs your control, one command after the other.";
const LOST = "Python does not answer. Run the cell again.";
const OTHERWISE = "Recorded with other settings.";
const LONGEST =
  "88.88 s: 188.8 px from the middle (mean 188.8 px), hidden; center 888 mm off (mean 888 mm). " +
  OTHERWISE;

export default defineView("following", start);

/**
 * @param {FollowingModel} model
 * @param {Frame} frame
 */
async function start(model, frame) {
  const frames = readRecording({
    moments: model.get("moments"),
    pictures: model.get("pictures"),
    places: model.get("places"),
  });
  const size = model.get("size");
  const eye = makePicture(frame.stage, size, "What the robot sees");
  const marks = makeMarks(eye.holder, size);
  const buttons = makeButtons(frame.stage);
  makeKey(frame.stage);
  const pair = make("div", "explorer-following-pair", frame.side);
  const outside = makePicture(pair, size, "The robot from outside");
  const budget = makeBudget(pair);
  const plots = makePlots(model, frame.side);
  const scrubber = makeScrubber(model, frame.side);
  const problem = make("p", "explorer-following-problem", frame.stage);
  problem.setAttribute("role", "alert");
  const note = make("p", "explorer-help explorer-following-note", frame.foot);
  note.setAttribute("role", "status");
  frame.reserve(LONGEST);

  const player = makePlayer(model, frames, {
    draw: () => again(),
    begin(seen, looked) {
      problem.textContent = "";
      eye.show(seen);
      outside.show(looked);
    },
    fail(told) {
      problem.textContent = writeProblem(told);
    },
  });
  const recorded = model.get("problem");
  if ("kind" in recorded)
    problem.textContent = writeProblem(/** @type {FollowingProblem} */ (recorded));

  const again = drawOnChange(model, frame, () => {
    const place = findPlace(model.get("moment"), frames.length);
    const values = {
      ...describeRun(frames, place),
      is_current: player.isLive || isAsRecorded(model),
    };
    const seen = findPicture(frames, place, "eye");
    if (seen) eye.show(seen.bytes);
    marks.show(seen ? seen.moment : null);
    outside.show(findPicture(frames, place, "outside")?.bytes ?? null);
    for (const plot of plots) plot.show(frames, place, model.get("dt"));
    budget.show(describeBudget(frames, place, model.get("neck_ms")));
    scrubber.show(place, frames);
    buttons.show(player);
    const words = player.isLive ? (player.isLost ? LOST : LIVE) : tellRecorded(model);
    if (note.textContent !== words) note.textContent = words;
    frame.root.dataset.answerMs = player.answerMs.toFixed(1);
    frame.root.dataset.mode = player.isLive ? "live" : "recorded";
    frame.root.dataset.steps = String(frames.length);
    frame.tell(inWords(values), values);
  });
  buttons.connect(player, () => {
    problem.textContent = "";
  });
  scrubber.connect(() => player.pause());
  frame.cleanups.push(player.destroy);
}

/**
 * The buttons below the picture, which stay in view with it.
 * @param {Element} parent
 */
function makeButtons(parent) {
  const row = make("div", "explorer-following-buttons", parent);
  const [run, step, restart, hide] = ["Run", "Step", "Start again", "Hide the ball"].map((name) => {
    const button = make("button", "explorer-button", row);
    button.type = "button";
    button.textContent = name;
    return button;
  });
  return {
    /** @param {ReturnType<typeof makePlayer>} player */
    show({ isLive, isRunning }) {
      const name = isRunning ? "Pause" : isLive ? "Run" : "Play";
      if (run.textContent !== name) run.textContent = name;
      hide.disabled = !isLive; // the note says how to make it live
    },
    /**
     * @param {ReturnType<typeof makePlayer>} player
     * @param {() => void} before
     */
    connect(player, before) {
      const connected = { toggle: run, step, restart, hide };
      for (const [name, button] of Object.entries(connected)) {
        button.addEventListener("click", () => {
          before();
          player[/** @type {keyof typeof connected} */ (name)]();
        });
      }
    },
  };
}

/** What the marks mean. */
function makeKey(/** @type {Element} */ parent) {
  const key = make("div", "explorer-key explorer-following-key", parent);
  for (const [sign, words] of [
    ["middle", "middle"],
    ["truth", "the ball, in truth"],
    ["told", "where control says it is"],
  ]) {
    const item = make("span", "explorer-key-item", key);
    make("span", `explorer-following-sign ${sign}`, item).setAttribute("aria-hidden", "true");
    item.append(words);
  }
}

/**
 * @param {FollowingModel} model
 * @param {Element} parent
 */
function makePlots(model, parent) {
  const pair = make("div", "explorer-pair explorer-following-plots", parent);
  const [nearPx, nearMm] = [model.get("near_px"), model.get("near_mm")];
  return [
    makeErrorPlot(pair, {
      name: "error_px",
      label: "ball from the middle (px)",
      unit: "px",
      missing: "behind the robot",
      bound: nearPx,
    }),
    makeErrorPlot(pair, {
      name: "error_mm",
      label: "center (mm)",
      unit: "mm",
      missing: 'memory["center"] is not set',
      bound: nearMm,
    }),
  ];
}

/**
 * The slider that goes through what has happened.
 * @param {FollowingModel} model
 * @param {Element} parent
 */
function makeScrubber(model, parent) {
  const label = make("label", "explorer-following-scrubber", parent);
  label.append("moment");
  const slider = make("input", "", label);
  slider.type = "range";
  slider.min = "0";
  slider.step = "1";
  return {
    /**
     * @param {number} place
     * @param {FollowingFrame[]} frames
     */
    show(place, frames) {
      slider.disabled = frames.length < 2;
      slider.max = String(Math.max(frames.length - 1, 1));
      slider.value = String(Math.max(place, 0));
      const time = place < 0 ? 0 : frames[place].moment.time;
      slider.setAttribute("aria-valuetext", `${time.toFixed(2)} s`);
    },
    /** @param {() => void} before */
    connect(before) {
      slider.addEventListener("input", () => {
        const moment = Number(slider.value);
        before();
        setTraits(model, { moment });
      });
    },
  };
}

/**
 * What was recorded, and how to drive the head oneself.
 * @param {FollowingModel} model
 */
function tellRecorded(model) {
  const { gain, delay, noise, speed } = model.get("recorded");
  return (
    `A recording: gain ${gain}, delay ${delay}, noise ${noise}, ${speed} m/s. Press Run on this ` +
    "cell, and sliders and board act."
  );
}

/**
 * Whether the sliders stand as they did when the run was recorded.
 * @param {FollowingModel} model
 */
function isAsRecorded(model) {
  const settings = Object.entries(model.get("recorded"));
  return settings.every(
    ([name, value]) => model.get(/** @type {keyof FollowingSettings} */ (name)) === value,
  );
}

/** @param {FollowingProblem} problem */
function writeProblem({ kind, message, line, code, time }) {
  const where = line === null ? "" : ` in line ${line}: ${code}`;
  return `control stopped the run at ${time.toFixed(2)} s${where}\n${kind}: ${message}`;
}

/** @param {FollowingValues & { is_current: boolean }} values */
function inWords({ time, error_px, error_mm, is_hidden, mean_px, mean_mm, is_current }) {
  if (time === null) return "Not begun: press Run.";
  const write = (
    /** @type {number | null} */ value,
    /** @type {number} */ digits,
    /** @type {string} */ unit,
  ) => (value === null ? "unknown" : `${value.toFixed(digits)} ${unit}`);
  const mean = (/** @type {string} */ words) => (words === "unknown" ? "" : ` (mean ${words})`);
  const center =
    error_mm === null && mean_mm === null
      ? ""
      : `; center ${error_mm === null ? "not told" : `${error_mm.toFixed(0)} mm off`}` +
        mean(write(mean_mm, 0, "mm"));
  return (
    `${time.toFixed(2)} s: ${write(error_px, 1, "px")} from the middle` +
    `${mean(write(mean_px, 1, "px"))}${is_hidden ? ", hidden" : ""}${center}.` +
    (is_current ? "" : ` ${OTHERWISE}`)
  );
}
