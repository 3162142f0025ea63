// Opens a large picture over the page, where the screen shows it small: a tap on it, or on the
// button below it. Escape, the button in the corner and another tap close it. zoom.css decides on
// which screens; without this script a reader can still spread two fingers.
(() => {
  const PICTURES =
    ".bd-article :is(figure:not(.hero), .cell_output, .cell-yours, .exercise-verdict) img:not(.explorer-poster)";
  const LARGE = 480; // px of its own width: a smaller one is whole on any screen
  const READABLE = 960; // px: letters are as large as on a desktop

  /**
   * @param {string} className
   * @param {string} text
   */
  function makeButton(className, text) {
    const button = document.createElement("button");
    button.type = "button";
    button.className = className;
    button.textContent = text;
    return button;
  }

  /** @param {HTMLImageElement} image */
  function open(image) {
    const view = document.createElement("dialog");
    view.className = "zoom-view";
    view.setAttribute("aria-label", "Picture at full size");
    const place = document.createElement("div");
    place.className = "zoom-picture";
    place.tabIndex = 0; // or the keyboard could not scroll it
    place.append(copy(image));
    const button = makeButton("zoom-close", "Close");
    view.append(button, place);
    view.addEventListener("click", () => view.close());
    view.addEventListener("close", () => view.remove());
    document.body.append(view);
    view.showModal(); // gives the focus back when it closes
  }

  /** @param {HTMLImageElement} image */
  function copy(image) {
    const large = new Image();
    large.src = image.currentSrc || image.src;
    large.alt = image.alt;
    large.style.width = `${Math.max(document.documentElement.clientWidth, READABLE)}px`;
    large.style.background = getComputedStyle(image).backgroundColor;
    return large;
  }

  /** @param {EventTarget | null} target */
  function prepare(target) {
    if (!(target instanceof HTMLImageElement) || !target.matches(PICTURES)) return;
    if (target.naturalWidth < LARGE || target.classList.contains("has-zoom")) return;
    const button = makeButton("zoom-button", "Enlarge");
    button.setAttribute("aria-label", "Enlarge the picture above");
    button.addEventListener("click", () => open(target));
    target.classList.add("has-zoom");
    // most pictures lead to their file, which a phone shows without a way back to the text
    const shown = target.closest("a.image-reference") ?? target;
    shown.after(button);
    shown.addEventListener("click", (event) => {
      if (!button.offsetParent) return; // the screen shows it large
      event.preventDefault();
      open(target);
    });
  }

  // pictures come late: when the reader is near, or when a cell has drawn them
  document.addEventListener("load", ({ target }) => prepare(target), true);
  for (const image of document.images) if (image.complete) prepare(image);
})();
