// The path on a page that shows it: how much of each chapter is done, and where to go on.
(() => {
  const { drawings, getNames } = window.cameraLab.path;
  const LAST = "book/rubric.html"; // where a reader who has solved everything goes

  /** One chapter of the path, as `book/_ext/path.py` has written it. */
  class Row {
    /** @param {HTMLElement} element */
    constructor(element) {
      const { required, optional, questions, predictions, exercises, skip } = element.dataset;
      this.required = getNames(required);
      this.optional = getNames(optional);
      this.questions = getNames(questions);
      this.predictions = getNames(predictions);
      this.exercises = exercises ?? "";
      this.isOptional = Boolean(skip);
      this.link = /** @type {HTMLAnchorElement} */ (element.querySelector(".path-title"));
      this.place = /** @type {HTMLElement} */ (element.querySelector(".path-done"));
    }

    /** Whether the reader has left any trace in the chapter. */
    isBegun(/** @type {PathDone} */ done) {
      return (
        [...this.required, ...this.optional].some(done.isTried) ||
        this.questions.some(done.isAnswered) ||
        this.predictions.some(done.isPredicted)
      );
    }

    /** What is due here before the next chapter: a text and an address, or null. */
    findDue(/** @type {PathDone} */ done) {
      if (this.isOptional) return null;
      const name = this.required.find((one) => !done.isSolved(one));
      const isDue = name ?? this.questions.find((one) => !done.isRight(one));
      const asks = this.required.length ? name : isDue;
      if (!asks) return null;
      if (name && this.isBegun(done)) return this.lead(name);
      return this.questions.length ? this.leadToPage() : null;
    }

    leadToPage() {
      return { text: String(this.link.textContent), href: this.link.href };
    }

    lead(/** @type {string} */ name) {
      const href = `${this.exercises}#exercise-${name.replaceAll("_", "-")}`;
      return { text: `the exercise ${name}`, href };
    }

    /** What is done, in words and as a bar. */
    draw(/** @type {PathDone} */ done) {
      const counts = /** @type {[string, string[], (name: string) => boolean][]} */ ([
        ["required", this.required, done.isSolved],
        ["challenges", this.optional, done.isSolved],
        ["questions", this.questions, done.isRight],
        ["predictions", this.predictions, done.isPredicted],
      ]);
      const told = counts
        .filter(([, names]) => names.length)
        .map(([word, names, is]) => ({ word, done: names.filter(is).length, all: names.length }));
      this.place.hidden = !told.length || !this.isBegun(done);
      if (this.place.hidden) return;
      const bar = document.createElement("progress");
      // challenges are nobody's duty: without them the bar can be full
      const due = told.filter(({ word }) => word !== "challenges");
      bar.max = due.reduce((sum, { all }) => sum + all, 0);
      bar.value = due.reduce((sum, one) => sum + one.done, 0);
      bar.setAttribute("aria-label", `Done of ${this.link.textContent}`);
      const words = told.map((one) => `${one.word} ${one.done} of ${one.all}`).join(", ");
      this.place.replaceChildren(bar, ` ${words}`);
    }
  }

  /** The first thing that is not done: what is required, then the challenges. */
  function findNext(/** @type {Row[]} */ rows, /** @type {PathDone} */ done) {
    for (const row of rows) {
      const due = row.findDue(done);
      if (due) return due;
    }
    for (const row of rows) {
      const name = row.optional.find((one) => !done.isSolved(one));
      if (name) return row.lead(name);
    }
    const root = document.documentElement.dataset.content_root ?? "./";
    return { text: "the rubric: everything is solved", href: `${root}${LAST}` };
  }

  /** @type {NodeListOf<HTMLElement>} */
  const items = document.querySelectorAll(".path li");
  const rows = [...items].map((item) => new Row(item));
  const line = /** @type {HTMLElement | null} */ (document.querySelector(".path-on"));

  drawings.push((/** @type {PathDone} */ done) => {
    for (const row of rows) row.draw(done);
    if (!line || done.isEmpty) return;
    const { text, href } = findNext(rows, done);
    const link = document.createElement("a");
    link.href = href;
    link.textContent = `Go on with ${text}`;
    line.replaceChildren(link);
    line.hidden = false;
  });
})();
