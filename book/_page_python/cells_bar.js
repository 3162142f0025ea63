// The bar above the cells of a page: run them all, take all changes back, take them along as a
// notebook.
(() => {
  const { assets, cells, elements, session } = window.cameraLab;
  const { make, makeButton } = elements;

  /** A notebook of the page's headings and cells, with the reader's code. */
  function makeNotebook() {
    const title = document.querySelector("h1");
    /** @type {object[]} */
    const content = [makeText(`# ${readHeading(title)}\n\nFrom ${location.href.split("#")[0]}`)];
    /** @type {HTMLElement | null} */
    let before = title;
    for (const cell of session.cells) {
      const heading = findHeading(cell.element);
      if (heading && heading !== before) {
        const level = Number(heading.tagName.slice(1));
        content.push(makeText(`${"#".repeat(level)} ${readHeading(heading)}`));
        before = heading;
      }
      content.push({
        cell_type: "code",
        source: cell.getText(),
        outputs: [],
        execution_count: null,
      });
    }
    const numbered = content.map((cell, i) => ({ id: `cell-${i}`, metadata: {}, ...cell }));
    const kernelspec = { display_name: "Python 3", language: "python", name: "python3" };
    return { cells: numbered, metadata: { kernelspec }, nbformat: 4, nbformat_minor: 5 };
  }

  const makeText = (/** @type {string} */ source) => ({ cell_type: "markdown", source });

  /** The text of a heading, without the link at its end. */
  function readHeading(/** @type {Element | null} */ heading) {
    const copy = /** @type {Element | undefined} */ (heading?.cloneNode(true));
    for (const link of copy?.querySelectorAll(".headerlink") ?? []) link.remove();
    return copy?.textContent?.trim() ?? "";
  }

  /** The heading of the section in which an element stands. */
  function findHeading(/** @type {HTMLElement} */ element) {
    const selector = ":scope > h1, :scope > h2, :scope > h3, :scope > h4";
    return /** @type {HTMLElement | null} */ (element.closest("section")?.querySelector(selector));
  }

  function download() {
    const name = `${assets.data.page.split("/").pop()}.ipynb`;
    elements.save(name, "application/x-ipynb+json", JSON.stringify(makeNotebook(), null, 1));
    return `Saved as ${name}, with your changes.`;
  }

  /** @implements {SessionCell} */
  class Bar {
    constructor(/** @type {HTMLElement} */ before) {
      this.key = this.name = "the page";
      this.title = "The page";
      this.isNeededBelow = false;
      this.skipped = "";
      this.isBusy = false;
      this.element = make("div", "cells-bar");
      this.runButton = makeButton("Run all", "cell-run", () => this.press());
      this.resetButton = makeButton("Reset all", "", () => this.reset());
      const save = makeButton("Save as notebook", "", () => this.tell(download()));
      this.status = make("span", "cell-status");
      this.element.append(this.makeNote(), this.runButton, this.resetButton, save, this.status);
      before.before(this.element);
      document.addEventListener("camera-lab-cells", () => this.showEdits());
      this.showEdits();
    }

    makeNote() {
      const needed = cells.list.flatMap((cell) => session.findParts(cell.getText()));
      const parts = ["python", "simulator"];
      const recorded = needed.includes("recordings");
      if (recorded) parts.push("recordings");
      const bytes = parts
        .filter((part) => part in assets.data.parts)
        .reduce((sum, part) => sum + assets.countBytes(part), 0);
      const size = `${(bytes / 1e6).toFixed(0)} MB`;
      const hosts = new Set(assets.data.remote.map(({ url }) => new URL(url).host));
      const network = hosts.size
        ? ` NumPy and OpenCV come from ${[...hosts]}, by the network.`
        : "";
      return make(
        "p",
        "",
        `The code on this page runs here, in your browser. The first run loads Python${recorded ? ", the recorded pictures" : ""} and the simulator (${size}).${network}`,
      );
    }

    press() {
      if (this.isBusy) session.stop(this);
      else this.runAll();
    }

    async runAll() {
      const good = await session.runAll(this);
      this.tell(good ? "All cells ran." : "Not all cells ran: see those marked.");
    }

    reset() {
      for (const cell of cells.list) if (cell.isEdited()) cell.reset();
      this.tell("All cells are the book's again.");
    }

    showEdits() {
      this.resetButton.hidden = !cells.list.some((cell) => cell.isEdited());
    }

    getText() {
      return "";
    }

    say(/** @type {string} */ text) {
      if (this.status.textContent !== text) this.status.textContent = text;
    }

    tell(/** @type {string} */ text) {
      this.say(text);
      cells.announce(text);
    }

    wait() {
      this.isBusy = true;
      this.runButton.textContent = "Stop";
      cells.announce("Running all cells");
    }

    rest() {
      this.isBusy = false;
      this.runButton.textContent = "Run all";
    }

    begin() {}
    print() {}
    async finish() {}
    fail() {}
    forget() {}
  }

  document.addEventListener("DOMContentLoaded", () => {
    const [first] = cells.list;
    if (!first) return;
    const place = document.querySelector(".exercise-bar") ?? first.element;
    const bar = new Bar(/** @type {HTMLElement} */ (place));
    window.cameraLab.bar = bar;
  });
})();
