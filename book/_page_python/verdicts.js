// What a check says, as elements of the page; and what the page knows about its exercises.
(() => {
  const { make } = window.cameraLab.elements;
  /** @type {ExerciseData} */
  const data = JSON.parse(document.getElementById("exercise-data")?.textContent ?? "");

  /** The verdict's own HTML, as in the notebook, in the colors of the page. */
  function makeVerdict(/** @type {string} */ html) {
    const verdict = make("div", "exercise-verdict");
    verdict.innerHTML = html;
    for (const element of verdict.querySelectorAll("[style]")) element.removeAttribute("style");
    nameLinks(verdict);
    return verdict;
  }

  /** Links of verdicts that the build has put on the page say their heading, too. */
  function nameLinks(/** @type {Element} */ parent) {
    for (const link of parent.querySelectorAll("a")) {
      const title = data.titles[link.getAttribute("href") ?? ""];
      if (title !== undefined) link.textContent = title;
    }
  }

  /** All that a check says. */
  function makeParts(/** @type {Said} */ said) {
    const parts = [];
    if (said.html) parts.push(makeVerdict(said.html));
    if (said.error) parts.push(make("pre", "exercise-error", said.error));
    if (said.printed) {
      parts.push(make("p", "exercise-label", "Printed by your code:"));
      parts.push(make("pre", "exercise-printed", said.printed, { tabindex: "0" }));
    }
    parts.push(make("p", "exercise-outdated", "Your code has changed since this check."));
    return parts;
  }

  window.cameraLab = { ...window.cameraLab, verdicts: { data, makeParts, nameLinks } };
})();
