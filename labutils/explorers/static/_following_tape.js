// What has happened, moment by moment: recorded with the view, or sent by Python as it happens.

export const LAST = -1; // the newest moment, whichever that is
const EYE = 0; // in `places`; 1 is outside
const LATELY = 20; // moments that a mean of times is taken of

/**
 * Read the run that came with the view.
 * @param {FollowingRecorded} recorded
 * @returns {FollowingFrame[]}
 */
export function readRecording({ moments, pictures, places }) {
  const names = Object.keys(moments);
  const count = names.length ? moments[names[0]].length : 0;
  const frames = Array.from({ length: count }, (_, i) => {
    const moment = Object.fromEntries(names.map((name) => [name, moments[name][i]]));
    /** @type {any} Python has written all names that belong to a moment */
    const known = moment;
    return { moment: known, eye: null, outside: null };
  });
  for (const [place, which, start, length] of places) {
    const bytes = new DataView(pictures.buffer, pictures.byteOffset + start, length);
    Object.assign(frames[place], { [which === EYE ? "eye" : "outside"]: bytes });
  }
  return frames;
}

/**
 * The place of the moment that is shown: the newest one, or the one that was chosen, if it is there.
 * @param {number} chosen
 * @param {number} count
 */
export function findPlace(chosen, count) {
  return chosen === LAST ? count - 1 : Math.min(chosen, count - 1);
}

/**
 * The newest picture of a kind until a place, and the moment it belongs to.
 * @param {FollowingFrame[]} frames
 * @param {number} place
 * @param {"eye" | "outside"} kind
 */
export function findPicture(frames, place, kind) {
  for (let i = place; i >= 0; i--) {
    const bytes = frames[i][kind];
    if (bytes) return { bytes, moment: frames[i].moment };
  }
  return null;
}

/**
 * The errors at a place, and their means until then; as in FollowingView.compute.
 * @param {FollowingFrame[]} frames
 * @param {number} place
 * @returns {FollowingValues}
 */
export function describeRun(frames, place) {
  if (place < 0) {
    return {
      time: null,
      error_px: null,
      error_mm: null,
      is_hidden: null,
      mean_px: null,
      mean_mm: null,
    };
  }
  const { time, error_px, error_mm, is_hidden } = frames[place].moment;
  const measured = frames
    .slice(0, place + 1)
    .map(({ moment }) => moment)
    .filter((moment) => moment.is_measured);
  return {
    time,
    error_px,
    error_mm,
    is_hidden,
    mean_px: findMean(measured.map((one) => one.error_px)),
    mean_mm: findMean(measured.map((one) => one.error_mm)),
  };
}

/** @param {(number | null)[]} values */
function findMean(values) {
  let [sum, count] = [0, 0];
  for (const value of values) {
    if (value === null) continue;
    sum += value;
    count += 1;
  }
  return count ? sum / count : null;
}

/**
 * Where the time goes from what is seen to what is done, in the last second.
 * @param {FollowingFrame[]} frames
 * @param {number} place
 * @param {number} neckMs
 * @returns {FollowingBudget[]}
 */
export function describeBudget(frames, place, neckMs) {
  const lately = frames.slice(Math.max(0, place + 1 - LATELY), place + 1);
  const mean = (/** @type {"delay_ms" | "render_ms" | "control_ms"} */ name) =>
    lately.length ? findMean(lately.map(({ moment }) => moment[name])) : 0;
  return [
    { name: "picture delay", ms: mean("delay_ms") },
    { name: "drawing", ms: mean("render_ms") },
    { name: "deciding", ms: mean("control_ms") },
    { name: "neck", ms: neckMs },
  ];
}

/**
 * From when to when the ball was hidden.
 * @param {FollowingFrame[]} frames
 * @param {number} dt
 * @returns {Pair[]}
 */
export function findHidden(frames, dt) {
  /** @type {Pair[]} */
  const spans = [];
  frames.forEach(({ moment }, i) => {
    if (!moment.is_hidden) return;
    const end = moment.time + dt;
    if (i && frames[i - 1].moment.is_hidden) spans[spans.length - 1][1] = end;
    else spans.push([moment.time, end]);
  });
  return spans;
}
