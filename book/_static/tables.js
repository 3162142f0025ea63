// A table or formula that is wider than its box scrolls inside it; then, and only then, the keyboard
// can stop there to scroll it.
(() => {
  const BOXES = ".bd-article :is(.pst-scrollable-table-container, mjx-container[display])";

  /** @param {Element} box */
  function update(box) {
    if (box.scrollWidth > box.clientWidth) box.setAttribute("tabindex", "0");
    else box.removeAttribute("tabindex");
  }

  // the box changes with the window, what is in it with its own fonts and pictures
  const observer = new ResizeObserver((entries) => {
    for (const { target } of entries) update(target.closest(BOXES) ?? target);
  });
  for (const box of document.querySelectorAll(BOXES)) {
    update(box);
    observer.observe(box);
    if (box.firstElementChild) observer.observe(box.firstElementChild);
  }
})();
