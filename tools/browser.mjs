// What scripts share that look at pages, for tests, benches and pictures: start Chromium, open a
// page and write down what goes wrong.

import { existsSync } from "node:fs";
import { createRequire } from "node:module";

/** Loads a package of _build/npm (tools/vendor/npm.py puts them there). */
export const require = createRequire(new URL("../_build/npm/", import.meta.url));

const BROWSERS = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"];
const FLAGS = [
  "--no-sandbox",
  "--disable-background-networking",
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
  // no page may need another host: none can be found
  "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1",
];
const OWN = /^(file|data|blob|about):/;
const SETTLE_MS = 15_000; // longest wait for the widgets of a page
const QUIET_MS = 1500; // longest wait for a network that never rests

export const DESKTOP = { width: 1280, height: 900 };
export const PHONE = { width: 390, height: 844 };
export const NARROW = { width: 360, height: 740 };

/** Starts the browser that CHROMIUM names, else the usual one, with more flags where given. */
export function launch(flags = []) {
  const { chromium } = require("playwright-core");
  return chromium.launch({
    executablePath: process.env.CHROMIUM || BROWSERS.find(existsSync),
    args: [...FLAGS, ...flags],
  });
}

/** A new tab, and the set of complaints that its page writes into. */
export async function newPage(browser, site, options = {}) {
  const context = await browser.newContext({
    viewport: DESKTOP,
    reducedMotion: "reduce",
    ...options,
  });
  const page = await context.newPage();
  const complaints = new Set();
  const isOwn = (address) => OWN.test(address) || address.startsWith(site);
  page.on("console", (m) => m.type() === "error" && complaints.add(`console: ${m.text()}`));
  page.on("pageerror", (error) => complaints.add(`script error: ${error.message}`));
  page.on("request", (r) => isOwn(r.url()) || complaints.add(`foreign: ${r.url()}`));
  page.on("requestfailed", (r) => complaints.add(`failed: ${r.url()} ${r.failure()?.errorText}`));
  page.on("response", (r) => {
    if (r.status() >= 400) complaints.add(`failed: ${r.url()} ${r.status()}`);
  });
  return { page, complaints };
}

/** Opens a page of the site ("book/start") in a new tab and waits until it is complete. */
export async function openPage(browser, site, name, options = {}) {
  const tab = await newPage(browser, site, options);
  await goTo(tab.page, site, name);
  return tab;
}

/** Goes to a page of the site in a tab that is open, opens it all, waits until it is complete. */
export async function goTo(page, site, name) {
  await page.goto(new URL(`${name}.html`, site).href, { waitUntil: "load" });
  await uncover(page);
  await settle(page);
}

/** Opens what the predictions of a page cover, as readers do who do not want to predict. */
export async function uncover(page) {
  await page.$$eval(".predict-show:not([hidden])", (all) => {
    for (const button of all) button.click();
  });
}

/** Makes the gesture on which explorers start: before it a page loads nothing for them. */
export function wake(page) {
  return page.evaluate(() => {
    // heard like a real key, but the focus stays where it is
    document.dispatchEvent(new KeyboardEvent("keydown", { key: "Tab" }));
  });
}

/** Starts the explorers; waits for them and the network. */
export async function settle(page) {
  await wake(page);
  const drawn = ({ views, count }) =>
    document.querySelectorAll(count).length >= document.querySelectorAll(views).length;
  await page.waitForFunction(drawn, WIDGETS, { timeout: SETTLE_MS }).catch(() => {});
  await rest(page);
}

/** Waits for the network, and touches nothing. */
export function rest(page) {
  return page.waitForLoadState("networkidle", { timeout: QUIET_MS }).catch(() => {});
}

/** Loads the pictures that wait until the reader comes near. */
export async function loadPictures(page) {
  await page.evaluate(async () => {
    const waiting = [...document.querySelectorAll("main img")];
    for (const image of waiting) image.loading = "eager";
    await Promise.allSettled(waiting.map((image) => image.decode()));
  });
}

/** Waits until what the page was asked to draw is drawn: the next frame, and the one after. */
export function waitForFrames(page) {
  return page.evaluate(
    () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))),
  );
}

/** Selectors: the widgets that a page announces, and those that are drawn. */
export const WIDGETS = {
  views: 'script[type$="widget-view+json"]',
  count: ".widget-subarea > .jupyter-widgets",
};

/** Closes the tab with all it stored. */
export const close = ({ page }) => page.context().close();

/** Names of the pages in the sidebar, in reading order. */
export async function pagesOfContents(browser, site) {
  const { page } = await newPage(browser, site);
  await page.goto(new URL("index.html", site).href);
  await page.waitForSelector("nav.bd-links"); // index.html redirects to the first page
  const links = await page.$$eval("nav.bd-links a.internal", (all) => all.map((a) => a.href));
  await page.context().close();
  const names = links.map((link) => link.split("#")[0].slice(site.length));
  return [...new Set(names)].map((name) => name.replace(/\.html$/, ""));
}

/** Does `work(name)` for every name, some at once; returns {name: what it returned}. */
export async function forEach(names, atOnce, work) {
  const results = {};
  const queue = [...names];
  const worker = async () => {
    for (let name = queue.shift(); name; name = queue.shift()) results[name] = await work(name);
  };
  await Promise.all(Array.from({ length: atOnce }, worker));
  return results;
}

/** Runs `work(browser, ...arguments)` in a fresh browser and prints its result as JSON. */
export async function main(work) {
  const browser = await launch();
  try {
    process.stdout.write(JSON.stringify(await work(browser, ...process.argv.slice(2))));
  } finally {
    await browser.close();
  }
}
