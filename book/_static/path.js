// How far the reader is, from what this browser keeps (progress.js, predict.js and quiz.js write
// it): counts in the sidebar, and where the skip link of an exercise page leads. Without scripts, and
// where nothing is kept, there are no numbers.
(() => {
  const KEYS = { progress: "camera-lab-book.progress", quiz: "camera-lab-book" };

  /**
   * What is kept below a key; an empty object where nothing is, or where it is not ours.
   * @param {string} key
   * @returns {any}
   */
  function read(key) {
    try {
      return JSON.parse(localStorage.getItem(key) ?? "") ?? {};
    } catch {
      return {};
    }
  }

  /** The names in an attribute. */
  function getNames(/** @type {string | undefined} */ text) {
    return text ? text.split(" ") : [];
  }

  /** What the reader has done. */
  class Done {
    constructor() {
      const { exercises, predictions } = read(KEYS.progress);
      /** @type {Record<string, { passed?: boolean, attempts?: number }>} */
      this.exercises = exercises ?? {};
      /** @type {Record<string, object>} */
      this.predictions = predictions ?? {};
      /** @type {Record<string, { right?: boolean }>} */
      this.answers = read(KEYS.quiz).quiz ?? {};
    }

    isSolved = (/** @type {string} */ name) => this.exercises[name]?.passed === true;
    isTried = (/** @type {string} */ name) => Boolean(this.exercises[name]?.attempts);
    isPredicted = (/** @type {string} */ name) => name in this.predictions;
    isAnswered = (/** @type {string} */ name) => name in this.answers;
    isRight = (/** @type {string} */ name) => this.answers[name]?.right === true;

    /** Whether there is anything at all. */
    get isEmpty() {
      const all = [this.exercises, this.predictions, this.answers];
      return all.every((one) => !Object.keys(one).length);
    }
  }

  function drawCounts(/** @type {PathDone} */ done) {
    /** @type {NodeListOf<HTMLElement>} */
    const places = document.querySelectorAll(".path-count");
    for (const place of places) {
      const names = getNames(place.dataset.exercises);
      const solved = names.filter(done.isSolved).length;
      const isDone = solved === names.length;
      place.textContent = isDone ? "✓" : `${solved}/${names.length}`;
      place.setAttribute("role", "img");
      place.setAttribute("aria-label", `${solved} of ${names.length} solved`);
      place.classList.toggle("is-done", isDone);
      place.hidden = false;
    }
  }

  /** Let the skip link lead to the first exercise of the page that is not solved. */
  function aimSkipLink(/** @type {PathDone} */ done) {
    const link = /** @type {HTMLAnchorElement | null} */ (document.querySelector(".path-skip"));
    /** @type {NodeListOf<HTMLElement>} */
    const mounts = document.querySelectorAll("[data-exercise]:not(.is-completion)");
    const next = [...mounts].find(({ dataset }) => !done.isSolved(String(dataset.exercise)));
    if (link && next)
      link.setAttribute("href", `#exercise-${String(next.dataset.exercise).replaceAll("_", "-")}`);
  }

  /** @type {((done: PathDone) => void)[]} */
  const drawings = [drawCounts, aimSkipLink];

  function draw() {
    const done = new Done();
    for (const one of drawings) one(done);
  }

  document.addEventListener("DOMContentLoaded", draw);
  document.addEventListener("camera-lab-progress", draw); // an exercise or a prediction of this page
  window.addEventListener("storage", draw); // another tab
  window.addEventListener("pageshow", draw); // back to a page that the browser has kept

  window.cameraLab = { ...window.cameraLab, path: { drawings, getNames } };
})();
