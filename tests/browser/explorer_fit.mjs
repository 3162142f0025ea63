// node explorer_fit.mjs SITE PAGE...: in windows of several sizes, gives the focus to every control
// of every explorer and prints what is in view by then: {page: {view: [explorer]}}.
// test_explorer_fit.py says what is right.

import { close, forEach, main, openPage, waitForFrames } from "../../tools/browser.mjs";

const VIEWS = {
  phone: { width: 390, height: 844 },
  landscape: { width: 844, height: 390 },
  laptop: { width: 1366, height: 650 },
  large: { width: 1920, height: 1080 },
};
const TABS_AT_ONCE = 2;

await main((browser, site, ...names) =>
  forEach(names, TABS_AT_ONCE, (name) => visit(browser, site, name)),
);

async function visit(browser, site, name) {
  const tab = await openPage(browser, site, name);
  const { page } = tab;
  await page.waitForFunction(() =>
    [...document.querySelectorAll(".explorer-box .explorer")].every(
      (one) => one.dataset.state === "ready",
    ),
  );
  const found = {};
  for (const [view, size] of Object.entries(VIEWS)) {
    await page.setViewportSize(size);
    await waitForFrames(page);
    found[view] = await page.evaluate(inspect);
  }
  await close(tab);
  return found;
}

/** Runs in the page: how large each explorer is, and what is seen while each control has the focus. */
async function inspect() {
  const header = document.querySelector(".bd-header-article").offsetHeight;
  const CONTROLS = ".noUi-handle, .widget-toggle-button, .explorer-side [role=slider]";
  const found = [];
  for (const box of document.querySelectorAll(".explorer-box")) {
    const { top, left, right, height } = box.getBoundingClientRect();
    window.scrollTo({ top: window.scrollY + top - header - 8, behavior: "instant" });
    const controls = [];
    for (const control of box.querySelectorAll(CONTROLS)) {
      control.focus();
      await new Promise(requestAnimationFrame);
      controls.push({ name: control.ariaLabel ?? control.textContent, ...look(box, control) });
    }
    const picture = getPicture(box).getBoundingClientRect();
    const tooWide = Math.max(right - document.documentElement.clientWidth, -left);
    found.push({
      name: box.querySelector(".explorer").dataset.explorer,
      height,
      tooWide,
      pictureWidth: picture.width,
      outside: findOutside(box),
      controls,
    });
  }
  return found;

  /** The picture that the controls change: the first of the stage. */
  function getPicture(box) {
    return box.querySelector(".explorer-stage :is(canvas, svg)");
  }

  /** How much of the height of the picture is seen, and whether the control can be used. */
  function look(box, control) {
    const picture = getPicture(box).getBoundingClientRect();
    const top = Math.max(picture.top, header);
    const seen = (Math.min(picture.bottom, window.innerHeight) - top) / picture.height;
    const { x, y, width, height } = control.getBoundingClientRect();
    const at = document.elementFromPoint(x + width / 2, y + height / 2);
    const usable = control.contains(at) || Boolean(at?.closest(".noUi-base, .explorer-dial"));
    return { seen, usable: usable && y >= header && y + height <= window.innerHeight };
  }

  /** What sticks out of the frame sideways. */
  function findOutside(box) {
    const { left, right } = box.getBoundingClientRect();
    return [...box.querySelectorAll(":not(svg *, .noUi-target, .noUi-target *)")]
      .filter((one) => {
        const rect = one.getBoundingClientRect();
        return rect.width > 1 && (rect.right > right + 1 || rect.left < left - 1);
      })
      .map((one) => `${one.tagName} ${one.getAttribute("class")}`);
  }
}
