// Steps from Python, one at a time: the next is asked for when one has come, so that nothing piles
// up and a slider acts with the next step.

const ANSWER_MS = 8000; // after that one may ask again: the question was lost

/**
 * Make what asks Python.
 * @param {FollowingAsking} model
 * @param {object} listener
 * @param {(answer: FollowingAnswer, buffers: FollowingBytes[]) => void} listener.hear
 * @param {() => void} listener.miss there was no answer
 */
export function makeFollowingSource(model, { hear, miss }) {
  const first = Math.floor(Math.random() * 1e9) * 1000; // another view of this model asks, too
  let id = first;
  let isWaiting = false;
  /** @type {ReturnType<typeof setTimeout>} */
  let timer;

  /** @type {FollowingListener} */
  const listen = (answer, buffers) => {
    if (answer.id === id && isWaiting) {
      clearTimeout(timer);
      isWaiting = false;
    }
    hear(answer, buffers);
  };
  model.on("msg:custom", listen);
  return {
    get isWaiting() {
      return isWaiting;
    },
    /**
     * Ask, unless an answer is still to come.
     * @param {string} kind
     * @param {object} more
     */
    ask(kind, more = {}) {
      if (isWaiting) return false;
      id += 1;
      isWaiting = true;
      timer = setTimeout(() => {
        isWaiting = false;
        miss();
      }, ANSWER_MS);
      model.send({ kind, id, ...more });
      return true;
    },
    destroy() {
      clearTimeout(timer);
      model.off("msg:custom", listen);
    },
  };
}
