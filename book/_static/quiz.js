// Lets the questions of a page answer. Without this script they can be read, and their
// answers unfolded. The reader's answers stay in this browser:
//
//   localStorage["camera-lab-book"] = {"version": 1, "quiz": {"2a": {"choice": 1, "right": true}}}
//
// Other parts of the book may keep their own entries beside "quiz".
/**
 * The parts of one question.
 * @typedef {object} Item
 * @property {HTMLFormElement} form
 * @property {string} id
 * @property {number} right
 * @property {HTMLInputElement[]} inputs
 * @property {HTMLButtonElement} button
 * @property {HTMLElement} feedback
 * @property {HTMLElement} answers
 */
/** @typedef {Record<string, { choice: number, right: boolean }>} Answers */

(() => {
  const KEY = "camera-lab-book";
  const VERSION = 1;

  /** What is stored, or an empty record; null where it cannot be used or is of another version. */
  function load() {
    try {
      const text = localStorage.getItem(KEY);
      if (text === null) return { version: VERSION, quiz: {} };
      const record = JSON.parse(text);
      if (record?.version !== VERSION) return null;
      if (typeof record.quiz !== "object" || record.quiz === null) record.quiz = {};
      return record;
    } catch {
      return null; // storage is switched off, or holds something that is not ours
    }
  }

  /**
   * Change the stored answers; where that is impossible the page works on without memory.
   * @param {(quiz: Answers) => void} change
   */
  function update(change) {
    const record = load();
    if (!record) return;
    change(record.quiz);
    try {
      localStorage.setItem(KEY, JSON.stringify(record));
    } catch {
      // full or switched off
    }
  }

  /**
   * @param {HTMLFormElement} form
   * @returns {Item}
   */
  function find(form) {
    const get = (/** @type {string} */ selector) =>
      /** @type {any} */ (form.querySelector(selector));
    return {
      form,
      id: String(form.dataset.quiz),
      right: Number(form.dataset.right),
      inputs: [...form.querySelectorAll("input")],
      button: get("button"),
      feedback: get(".quiz-feedback"),
      answers: get(".quiz-answers"),
    };
  }

  function choiceOf(/** @type {Item} */ item) {
    return item.inputs.findIndex((input) => input.checked);
  }

  function clear(/** @type {Item} */ item) {
    item.feedback.replaceChildren();
    delete item.form.dataset.verdict;
  }

  /**
   * Show what there is to say about a choice, and where to read again.
   * @param {Item} item
   * @param {number} choice
   */
  function show(item, choice) {
    const said = item.answers.querySelector(`[data-choice="${choice}"]`);
    const isRight = choice === item.right;
    const again = isRight ? null : item.answers.querySelector(".quiz-again");
    const paragraphs = [said, again].filter((p) => p !== null);
    item.feedback.replaceChildren(...paragraphs.map((p) => p.cloneNode(true)));
    item.form.dataset.verdict = isRight ? "right" : "wrong";
  }

  /**
   * @param {Item} item
   * @param {{ draw: () => void }} summary
   */
  function check(item, summary) {
    const choice = choiceOf(item);
    if (choice < 0) {
      const request = document.createElement("p");
      request.textContent = "Choose an answer first.";
      item.feedback.replaceChildren(request);
      return;
    }
    show(item, choice);
    update((quiz) => {
      quiz[item.id] = { choice, right: choice === item.right };
    });
    summary.draw();
  }

  /**
   * Bring back an earlier answer, unless the question has changed since.
   * @param {Item} item
   * @param {Answers[string] | undefined} stored
   */
  function restore(item, stored) {
    const input = stored && item.inputs[stored.choice];
    if (!input || stored.right !== (stored.choice === item.right)) return;
    input.checked = true;
    show(item, stored.choice);
  }

  /**
   * The line below the questions: how many are right, and a way to start over.
   * @param {Item[]} items
   */
  function makeSummary(items) {
    const element = document.createElement("p");
    element.className = "quiz-summary";
    const count = document.createElement("span");
    count.setAttribute("role", "status");
    const again = document.createElement("button");
    again.type = "button";
    again.textContent = "Start over";
    element.append(count, " ", again);

    function draw() {
      const rights = items.filter((item) => item.form.dataset.verdict === "right").length;
      const answered = items.some((item) => item.form.dataset.verdict);
      count.textContent = `${rights} of ${items.length} right`;
      again.disabled = !answered;
    }
    again.addEventListener("click", () => {
      update((quiz) => {
        for (const item of items) delete quiz[item.id];
      });
      for (const item of items) {
        item.form.reset();
        clear(item);
      }
      draw();
      items[0].inputs[0].focus(); // the button that had the focus is disabled now
    });
    return { element, draw };
  }

  function start(/** @type {Element} */ quiz) {
    const forms = /** @type {NodeListOf<HTMLFormElement>} */ (quiz.querySelectorAll(".quiz-item"));
    const items = [...forms].map(find);
    const summary = makeSummary(items);
    quiz.append(summary.element);
    for (const item of items) {
      item.answers.hidden = true;
      item.button.hidden = false;
      item.form.addEventListener("submit", (event) => {
        event.preventDefault();
        check(item, summary);
      });
      item.form.addEventListener("change", () => {
        clear(item);
        summary.draw();
      });
    }
    const stored = load()?.quiz ?? {};
    for (const item of items) {
      item.form.reset(); // a browser may bring back a choice without its feedback
      restore(item, stored[item.id]);
    }
    summary.draw();
  }

  function startAll() {
    for (const quiz of document.querySelectorAll(".quiz")) start(quiz);
  }

  document.addEventListener("DOMContentLoaded", startAll);
})();
