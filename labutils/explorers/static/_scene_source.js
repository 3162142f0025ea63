// Pictures from Python, one at a time: the next is asked for when one has come, with what is set by
// then. Where no Python answers, the picture that came with the view stays.

const ANSWER_MS = 5000; // after that one may ask again: the question was lost

/** @type {(keyof ScenePose)[]} */
const NAMES = ["pan_deg", "tilt_deg", "ball_x", "ball_y"];

/**
 * What the reader has set.
 * @param {Model<ScenePose>} model
 * @returns {ScenePose}
 */
export function readPose(model) {
  const [pan_deg, tilt_deg, ball_x, ball_y] = NAMES.map((name) => model.get(name));
  return { pan_deg, tilt_deg, ball_x, ball_y };
}

/**
 * Whether two poses are the same, as far as a slider could tell; as in SceneView.compute.
 * @param {ScenePose} one
 * @param {ScenePose} other
 */
export function isSamePose(one, other) {
  return NAMES.every((name) => Math.abs(one[name] - other[name]) <= 1e-6);
}

/**
 * Read an answer: color in rows of RGB, depth in steps.
 * @param {SceneAnswer} answer
 * @param {DataView<ArrayBuffer>[]} buffers
 * @returns {SceneFrame}
 */
export function readFrame({ width, height, pose, ball_px }, [color, depth]) {
  const rgb = new Uint8Array(color.buffer, color.byteOffset, color.byteLength);
  const steps = new Uint16Array(width * height);
  // low byte first, whatever this machine does, and wherever the bytes begin
  for (let i = 0; i < steps.length; i++) steps[i] = depth.getUint16(2 * i, true);
  return { width, height, pose, ball_px, rgb, steps };
}

/**
 * Ask Python for pictures: `ask` whenever something has changed. Returns also what ends it.
 * @param {AskingModel & Model<ScenePose>} model
 * @param {object} listener
 * @param {(frame: SceneFrame) => void} listener.show
 * @param {() => void} listener.miss there was no answer
 */
export function makeSceneSource(model, { show, miss }) {
  let id = 0;
  let isWaiting = false;
  let isOutdated = false;
  /** @type {ReturnType<typeof setTimeout>} */
  let timer;

  function ask() {
    if (isWaiting) {
      isOutdated = true;
      return;
    }
    id += 1;
    isWaiting = true;
    isOutdated = false;
    clearTimeout(timer);
    timer = setTimeout(() => {
      miss();
      release();
    }, ANSWER_MS);
    model.send({ kind: "draw", id, pose: readPose(model) });
  }

  function release() {
    isWaiting = false;
    if (isOutdated) ask();
  }

  /**
   * @param {SceneAnswer} answer
   * @param {DataView<ArrayBuffer>[]} buffers
   */
  function hear(answer, buffers) {
    if (answer.kind !== "drawn") return;
    show(readFrame(answer, buffers)); // also what another view of this model has asked for
    if (answer.id !== id) return;
    clearTimeout(timer);
    release();
  }

  model.on("msg:custom", hear);
  return {
    ask,
    destroy() {
      clearTimeout(timer);
      model.off("msg:custom", hear);
    },
  };
}
