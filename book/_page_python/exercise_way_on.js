// Where an exercise leads that has been passed.
(() => {
  const { progress, verdicts } = window.cameraLab;
  const { make } = window.cameraLab.elements;
  const { data } = verdicts;

  /** Where to go after an exercise: to the next one that is not solved, else to the next page. */
  function makeWayOn(/** @type {string} */ name) {
    const records = progress.load().exercises;
    // in the order of the page, which the data does not have
    /** @type {NodeListOf<HTMLElement>} */
    const mounts = document.querySelectorAll(".exercise[data-exercise]");
    const names = [...mounts].map((mount) => String(mount.dataset.exercise));
    const later = names.slice(names.indexOf(name) + 1);
    const isLeft = (/** @type {string} */ one) =>
      !data.exercises[one].isCompletion && !records.get(one)?.passed;
    const next = [...later, ...names].find(isLeft);
    const section = document.querySelector(`[data-exercise="${next}"]`)?.closest("section");
    const page = /** @type {HTMLAnchorElement | null} */ (document.querySelector("a.right-next"));
    const line = make("p", "exercise-on", "Go on: ");
    if (section) {
      const title = section.querySelector("h2, h3")?.firstChild?.textContent ?? String(next);
      line.append(make("a", "", title, { href: `#${section.id}` }));
    } else if (page) {
      const title = page.querySelector(".prev-next-title")?.textContent ?? page.textContent;
      line.append(make("a", "", String(title).trim(), { href: page.href }));
    } else {
      line.textContent = "All exercises of this page are solved.";
    }
    return line;
  }

  window.cameraLab = { ...window.cameraLab, makeWayOn };
})();
