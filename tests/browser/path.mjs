// node path.mjs SITE EXERCISES ANSWER: follows the path as a reader does, by the sidebar, by the rows
// of the welcome page and by keyboard, and prints what was seen. EXERCISES is an exercise page, ANSWER a
// file with the right code of its first exercise, or "" where Python is not packed.

import { readFileSync } from "node:fs";
import { close, main, newPage, openPage, PHONE, require } from "../../tools/browser.mjs";
import * as ui from "./_exercises.mjs";

const WELCOME = "book/index";
const LAST_STOP = 80;
const passed = { passed: true, attempts: 1, hints: 0, last_property: null, mistakes: {} };
const tried = { ...passed, passed: false };

await main(async (browser, site, exercises, answer) => ({
  fresh: await withProgress(browser, site, {}),
  begun: await withProgress(browser, site, { exercises: { render_camera: tried } }),
  predicted: await withProgress(browser, site, {
    exercises: {},
    predictions: { stale: { said: "2", right: true } },
  }),
  solved: await withProgress(browser, site, { exercises: { render_camera: passed } }),
  damaged: await withProgress(browser, site, "no JSON"),
  plain: await withoutScripts(browser, site),
  phone: await onPhone(browser, site),
  keyboard: await byKeyboard(browser, site, exercises),
  pass: answer ? await passOne(browser, site, exercises, readFileSync(answer, "utf8")) : null,
}));

/** What the welcome page says to a reader with this progress file. */
async function withProgress(browser, site, progress) {
  const tab = await newPage(browser, site);
  const { page, complaints } = tab;
  await page.addInitScript(
    (text) => localStorage.setItem("camera-lab-book.progress", text),
    typeof progress === "string" ? progress : JSON.stringify({ version: 1, ...progress }),
  );
  await page.goto(new URL(`${WELCOME}.html`, site).href);
  const seen = await page.evaluate(look);
  await close(tab);
  return { ...seen, complaints: [...complaints] };
}

/** Runs in the page: what is shown of the reader's progress, and where it leads. */
function look() {
  const shown = (selector) =>
    [...document.querySelectorAll(selector)].filter((one) => one.checkVisibility());
  const goOn = shown(".path-on a")[0];
  return {
    goOn: goOn ? [goOn.textContent, new URL(goOn.href).pathname.split("/").pop(), goOn.hash] : null,
    rows: shown(".path li").length,
    counts: shown("nav.bd-links .path-count").map((one) => one.textContent),
    labels: shown("nav.bd-links .path-count").map((one) => one.getAttribute("aria-label")),
    done: shown(".path-done").map((one) => one.textContent.trim()),
    bars: shown(".path-done progress").map((one) => [one.value, one.max]),
    groups: shown("nav.bd-links li.has-children").map((one) =>
      [...one.querySelectorAll("a")].map((a) => a.firstChild.textContent.trim()),
    ),
  };
}

async function withoutScripts(browser, site) {
  const tab = await newPage(browser, site, { javaScriptEnabled: false });
  await tab.page.goto(new URL(`${WELCOME}.html`, site).href);
  const seen = {
    counts: await tab.page.locator(".path-count:visible, .path-done:visible").count(),
    goOn: await tab.page.locator(".path-on:visible").count(),
    rows: await tab.page.locator(".path li:visible").count(),
    groups: await tab.page.locator("nav.bd-links li.has-children li a:visible").count(),
  };
  await close(tab);
  return seen;
}

/** Opens the drawer of a phone; axe-core looks at it, and at the rows. */
async function onPhone(browser, site) {
  const tab = await openPage(browser, site, WELCOME, { viewport: PHONE });
  const { page } = tab;
  const sideways = await page.evaluate(
    () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
  );
  await page.locator(".primary-toggle").click();
  const link = page.getByRole("link", { name: /Exercises of step 3/ });
  await link.waitFor();
  const box = await link.boundingBox();
  await page.addScriptTag({ path: require.resolve("axe-core/axe.min.js") });
  const { violations } = await page.evaluate(() => window.axe.run(document, { preload: false }));
  const barriers = violations
    .filter(({ impact }) => /serious|critical/.test(impact))
    .map(({ id, nodes }) => `${id}: ${nodes[0].html.slice(0, 200)}`);
  await link.click();
  await page.waitForURL(/step3_depth/);
  const reached = page.url().slice(site.length);
  await close(tab);
  return { sideways, fits: box.x >= 0 && box.x + box.width <= PHONE.width, barriers, reached };
}

/** Counts the keys from the top of an exercise page to its first editor, by the skip link. */
async function byKeyboard(browser, site, name) {
  const tab = await openPage(browser, site, name);
  const { page } = tab;
  const stops = [];
  for (let keys = 1; keys < LAST_STOP; keys++) {
    await page.keyboard.press("Tab");
    const stop = await page.evaluate(() => {
      const { activeElement: at } = document;
      return { text: at.textContent.trim().slice(0, 40), edits: Boolean(at.closest(".cm-editor")) };
    });
    stops.push(stop.text);
    if (stop.edits) break;
    if (stop.text === "Skip to the exercises") {
      await page.keyboard.press("Enter");
      stops.push("Enter");
    }
  }
  const hash = new URL(page.url()).hash;
  await close(tab);
  return { stops, hash };
}

/** Solves the first exercise of a page; another tab shows the welcome page meanwhile. */
async function passOne(browser, site, name, code) {
  const tab = await openPage(browser, site, name);
  const { page, complaints } = tab;
  const other = await page.context().newPage();
  await other.goto(new URL(`${WELCOME}.html`, site).href);
  const count = page.locator('.path-count[data-exercises^="process_depth"]');
  const before = await count.textContent();
  const starter = await ui.check(page, "process_depth");
  const colors = await page.evaluate(() => {
    const verdict = document.querySelector(".exercise-verdict > div");
    const border = getComputedStyle(verdict).borderLeftColor;
    const probe = document.createElement("i");
    document.body.append(probe);
    const get = (name) => {
      probe.style.color = `var(${name})`;
      return getComputedStyle(probe).color;
    };
    return { border, control: get("--control"), failed: get("--failed") };
  });
  const said = await ui.check(page, "process_depth", code);
  const after = await count.textContent();
  await other.waitForFunction(() => document.querySelector(".path-on a"));
  const elsewhere = await other.evaluate(look);
  await page.reload();
  await page.waitForSelector(".exercise .cm-line");
  const skip = await page.locator(".path-skip").getAttribute("href");
  await close(tab);
  return { before, starter, colors, said, after, elsewhere, skip, complaints: [...complaints] };
}
