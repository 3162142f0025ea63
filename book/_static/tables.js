// A table or formula that is wider than its box scrolls inside it; then, and only then, the keyboard can stop
// there to scroll it.
(() => {
  /** @param {ResizeObserverEntry[]} entries */
  function update(entries) {
    for (const { target } of entries) {
      if (target.scrollWidth > target.clientWidth) target.setAttribute("tabindex", "0");
      else target.removeAttribute("tabindex");
    }
  }

  const observer = new ResizeObserver(update);
  const boxes = document.querySelectorAll(
    ".bd-article :is(.pst-scrollable-table-container, mjx-container[display])",
  );
  for (const box of boxes) observer.observe(box);
})();
