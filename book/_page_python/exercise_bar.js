// The bar above the exercises of a page: how many are solved, and the progress as a file, the same
// that a notebook writes and reads.
(() => {
  const { progress, verdicts } = window.cameraLab;
  const { makeButton, save } = window.cameraLab.elements;

  /**
   * Say how many are solved; returns {solved, total}.
   * @param {string[]} names
   */
  function count(names) {
    const records = progress.load().exercises;
    const solved = names.filter((name) => records.get(name)?.passed).length;
    return { solved, total: names.length };
  }

  function exportFile() {
    save(progress.FILE_NAME, "application/json", progress.text());
    return `Saved as ${progress.FILE_NAME}: put it beside your notebook, or import it elsewhere.`;
  }

  async function importFile(/** @type {File} */ file) {
    try {
      const records = progress.parse(await file.text());
      progress.merge(records);
      const kept = progress.isKept() ? "" : " This browser keeps it only until you leave.";
      return `Imported: ${records.exercises.size} exercises. What was solved before stays solved.${kept}`;
    } catch (thrown) {
      const error = /** @type {Error} */ (thrown);
      return `${file.name} is no progress file: ${error.message}. Nothing was changed.`;
    }
  }

  function build(/** @type {HTMLElement} */ bar) {
    const { exercises } = verdicts.data;
    const names = Object.keys(exercises).filter((name) => !exercises[name].isCompletion);
    const meter = document.createElement("progress");
    const text = document.createElement("span");
    const status = document.createElement("p");
    status.setAttribute("role", "status");
    meter.max = names.length;
    meter.setAttribute("aria-label", "Solved exercises of this page");
    text.className = "exercise-count";

    const draw = () => {
      const { solved, total } = count(names);
      meter.value = solved;
      text.textContent = `${solved} of ${total} solved on this page`;
    };
    const input = document.createElement("input");
    input.type = "file";
    input.accept = ".json,application/json";
    input.hidden = true;
    input.addEventListener("change", async () => {
      if (input.files?.length) status.textContent = await importFile(input.files[0]);
      input.value = ""; // the same file may be chosen again
    });
    const buttons = document.createElement("span");
    buttons.className = "exercise-buttons";
    buttons.append(
      makeButton("Export", "", () => {
        status.textContent = exportFile();
      }),
      makeButton("Import", "", () => input.click()),
      input,
    );
    bar.append(meter, text, buttons, status);
    bar.hidden = false;
    draw();
    document.addEventListener("camera-lab-progress", draw);
    window.addEventListener("storage", draw); // another tab
  }

  document.addEventListener("DOMContentLoaded", () => {
    /** @type {HTMLElement | null} */
    const bar = document.querySelector(".exercise-bar");
    if (bar) build(bar);
  });
})();
