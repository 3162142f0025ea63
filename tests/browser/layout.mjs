// node layout.mjs SITE PAGE...: opens every page in windows of several sizes and on paper, and
// prints {page: {view: what was found}}, and what axe-core says on a phone. test_layout.py says
// what is right.

import { readFileSync } from "node:fs";

import { close, forEach, main, openPage, require, waitForFrames } from "../../tools/browser.mjs";

const VIEWS = {
  phone: { width: 390, height: 844 },
  landscape: { width: 844, height: 390 },
  small: { width: 1265, height: 650 }, // 1280 less a scroll bar
  laptop: { width: 1366, height: 650 },
  large: { width: 1920, height: 1080 },
};
const PAPER = { width: 700, height: 1000 }; // A4 within its margins
const TABS_AT_ONCE = 2;
const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");

await main((browser, site, ...names) =>
  forEach(names, TABS_AT_ONCE, (name) => visit(browser, site, name)),
);

async function visit(browser, site, name) {
  const tab = await openPage(browser, site, name);
  const { page } = tab;
  await page.evaluate(() => {
    for (const folded of document.querySelectorAll("main details")) folded.open = true;
    for (const image of document.querySelectorAll("main img")) image.loading = "eager";
  });
  const found = {};
  for (const [view, size] of Object.entries(VIEWS)) {
    await page.setViewportSize(size);
    await waitForFrames(page);
    found[view] = await page.evaluate(inspect);
  }
  await page.setViewportSize(PAPER);
  await page.emulateMedia({ media: "print" });
  found.paper = await page.evaluate(inspect);
  await page.emulateMedia({ media: "screen" });
  await page.setViewportSize(VIEWS.phone);
  await waitForFrames(page); // what scrolls now is reached by keys from the next frame on
  await page.evaluate(axe);
  found.phone.barriers = await page.evaluate(runAxe);
  await close(tab);
  return found;
}

/** Runs in the page: what is too wide, cut off, wrapped, hard to read or small. */
function inspect() {
  const { scrollWidth, clientWidth } = document.documentElement;
  const column = document.querySelector(".bd-article-container")?.clientWidth ?? 0;
  const all = (selector) =>
    [...document.querySelectorAll(`.bd-article ${selector}`)].filter((one) => one.offsetWidth);
  const width = (element) => element.getBoundingClientRect().width;
  const lineHeight = (element) => Number.parseFloat(getComputedStyle(element).lineHeight);
  const goesOn = (line) => line.offsetHeight > 1.5 * lineHeight(line);
  const blocks = all(".highlight > pre");
  const paragraphs = all("section > p").filter(isLong);
  return {
    tooWide: scrollWidth - clientWidth,
    column,
    blocks: blocks.length,
    cut: all("pre")
      .filter((pre) => pre.scrollWidth > pre.clientWidth + 1)
      .map(begin),
    wrapped: all(".code-line").filter(goesOn).map(begin),
    unmarked: blocks.filter(hasUnmarkedWrap).map(begin),
    tables: all("table.table").filter(isCut).map(begin),
    measure: paragraphs.length >= 3 ? charactersPerLine(paragraphs) : null,
    cells: all("section > .cell").map(width),
    broad: all("figure:not(.hero) img[data-broad]").map(width),
    lopsided: clientWidth < 1200 ? all("section > p, section > h2").map(lopsidedness) : [],
  };

  function begin(element) {
    return element.textContent.trim().slice(0, 60);
  }

  /** Whether more lines are seen than there are, beside those that are marked as long. */
  function hasUnmarkedWrap(pre) {
    const { paddingTop, paddingBottom } = getComputedStyle(pre);
    const seen =
      pre.clientHeight - Number.parseFloat(paddingTop) - Number.parseFloat(paddingBottom);
    const marked = [...pre.querySelectorAll(".code-line")];
    const others = pre.textContent.replace(/\n$/, "").split("\n").length - marked.length;
    const due = marked.reduce((sum, line) => sum + line.offsetHeight, others * lineHeight(pre));
    return seen > due + 0.5 * lineHeight(pre);
  }

  /** Whether a table is wider than the box that would scroll it. */
  function isCut(table) {
    const box = table.closest(".pst-scrollable-table-container, .cell_output");
    return width(table) > width(box) + 1 && getComputedStyle(box).overflowX === "visible";
  }

  function countLines(paragraph) {
    return Math.round(paragraph.offsetHeight / lineHeight(paragraph));
  }

  /** Whether a paragraph is text alone, and of some length. */
  function isLong(paragraph) {
    return !paragraph.querySelector("mjx-container, img, code") && countLines(paragraph) >= 3;
  }

  /** On the average; a last line is half full. */
  function charactersPerLine(paragraphs) {
    const sum = (count) => paragraphs.reduce((total, one) => total + count(one), 0);
    return sum((one) => one.textContent.length) / sum((one) => countLines(one) - 0.5);
  }

  /** How much more room there is on one side of a block than on the other. */
  function lopsidedness(block) {
    const { left, right } = block.getBoundingClientRect();
    return Math.abs(left - (clientWidth - right));
  }
}

/** Runs in the page: what axe-core finds that a reader could not work around. */
async function runAxe() {
  const { violations } = await window.axe.run(document, {
    preload: false,
    resultTypes: ["violations"],
  });
  return violations
    .filter(({ impact }) => ["serious", "critical"].includes(impact))
    .map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.target.join(" ")).join("; ")}`);
}
