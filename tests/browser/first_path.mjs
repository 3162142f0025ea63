// node first_path.mjs SITE ANSWER: goes from the welcome page to the first action and to the first
// solved exercise as a reader would, and counts pages, clicks, drags, texts typed and windows
// scrolled. test_first_path.py says what is right.

import { close, main, newPage } from "../../tools/browser.mjs";
import { setCode, settle } from "./_exercises.mjs";

const LAPTOP = { width: 1366, height: 650 };
const FIRST = "intrinsics_matrix";

await main(async (browser, site, answer) => ({
  action: await actFirst(browser, site),
  exercise: await solveFirst(browser, site, answer),
}));

/** A reader at a laptop, with what was needed of hands. */
async function start(browser, site) {
  const tab = await newPage(browser, site, { viewport: LAPTOP });
  const counts = { pages: 1, clicks: 0, drags: 0, typed: 0, windows: 0 };
  const { page } = tab;
  await page.goto(new URL("index.html", site).href);
  await page.waitForSelector("article h1"); // index.html leads on to the first page

  /** Scrolls until a part can be used, at most a window at a time. */
  const reach = async (target) => {
    await target.waitFor();
    const away = await target.evaluate((element) => {
      const { top, bottom } = element.getBoundingClientRect();
      const [head, foot] = [60, window.innerHeight]; // below the header
      if (top >= head && Math.min(bottom, top + 100) <= foot) return 0;
      return Math.abs(top - head) / window.innerHeight;
    });
    counts.windows += Math.ceil(away);
    await target.scrollIntoViewIfNeeded();
  };
  const click = async (target) => {
    await reach(target);
    const { pathname } = new URL(page.url());
    await target.click();
    await page.waitForLoadState("load");
    counts.clicks += 1;
    counts.pages += Number(new URL(page.url()).pathname !== pathname);
  };
  return { tab, page, counts, reach, click };
}

/** Drags the picture of the first screen: it lifts into 3-D. */
async function actFirst(browser, site) {
  const { tab, page, counts, reach } = await start(browser, site);
  const stage = page.locator(".hero-stage");
  await page.waitForSelector(".hero[data-state]");
  await reach(stage);
  const { x, y, width, height } = await stage.boundingBox();
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(x + width / 2 + 80, y + height / 2 - 20, { steps: 5 });
  await page.mouse.up();
  counts.drags += 1;
  await page.waitForSelector('.hero[data-state="lifted"]');
  await close(tab);
  return { ...counts, complaints: [...tab.complaints] };
}

/** Follows the welcome page's own link to an exercise, writes the answer and checks it. */
async function solveFirst(browser, site, answer) {
  const { tab, page, counts, reach, click } = await start(browser, site);
  await click(page.getByRole("link", { name: "Solve your first exercise" }));
  const exercise = page.locator(`.exercise[data-exercise="${FIRST}"]`);
  const editor = exercise.locator(".cm-content");
  await reach(editor);
  await setCode(page, FIRST, answer);
  counts.typed += 1;
  await click(exercise.getByRole("button", { name: "Check", exact: true }));
  const { result } = await settle(page, FIRST);
  await close(tab);
  return { ...counts, result, complaints: [...tab.complaints] };
}
