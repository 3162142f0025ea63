// Look at every page of the built book, as a reader with a browser would.
//
//   make book                                   (fetches the browser driver too)
//   node tools/draw/screenshots.mjs _build/html OUT [page ...]
//
// Writes OUT/<page>.<light|dark>.<desktop|phone>[.<part>].png and prints, per page, console errors,
// failed or foreign requests, sideways scrolling at 360 px and images without alternative
// text. Exits 1 if there is any. CHROMIUM names the browser; without a page, all of the
// table of contents are visited. The pages are opened from file://.

import { mkdirSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

import * as browsing from "../browser.mjs";

const { DESKTOP, NARROW, PHONE, WIDGETS } = browsing;
const SIZES = { desktop: DESKTOP, phone: PHONE };
const THEMES = ["light", "dark"];
const TALLEST = 7000; // px; of a taller window Chromium repeats the top

const [folder, out, ...wanted] = process.argv.slice(2);
if (!folder || !out) {
  console.error("usage: node tools/draw/screenshots.mjs HTML_FOLDER OUT [page ...]");
  process.exit(2);
}
const site = pathToFileURL(`${resolve(folder)}/`).href;

const browser = await browsing.launch();
const pages = wanted.length ? wanted : await browsing.pagesOfContents(browser, site);
mkdirSync(out, { recursive: true });
let complaints = 0;
for (const name of pages) complaints += report(name, await visit(name));
console.log(`${pages.length} pages, ${complaints} complaints, pictures in ${out}`);
await browser.close();
process.exit(complaints ? 1 : 0);

/** Photograph one page in both themes and sizes; return what is wrong with it. */
async function visit(name) {
  const found = new Set();
  for (const theme of THEMES) {
    for (const [size, viewport] of Object.entries(SIZES)) {
      const page = await openPage(name, { colorScheme: theme, viewport }, found);
      const file = `${name.replaceAll("/", "-")}.${theme}.${size}`;
      // tall windows: Chromium's own full-page mode loses what scrolls inside the sidebar
      const height = await page.evaluate(() => document.documentElement.scrollHeight);
      const step = Math.min(height, TALLEST);
      await page.setViewportSize({ width: viewport.width, height: step });
      for (let part = 0; part * step < height; part++) {
        await page.evaluate((top) => window.scrollTo(0, top), part * step);
        const number = height > step ? `.${part + 1}` : "";
        await page.screenshot({ path: join(out, `${file}${number}.png`) });
      }
      await page.context().close();
    }
  }
  const page = await openPage(name, { viewport: NARROW }, found);
  for (const complaint of await page.evaluate(inspect, WIDGETS)) found.add(complaint);
  await page.context().close();
  return found;
}

async function openPage(name, options, found) {
  const { page, complaints } = await browsing.openPage(browser, site, name, options);
  await browsing.loadPictures(page);
  for (const complaint of complaints) found.add(complaint);
  return page;
}

/** Runs in the page: what a phone or a screen reader would trip over. */
function inspect(widgets) {
  const said = [];
  const { scrollWidth, clientWidth } = document.documentElement;
  if (scrollWidth > clientWidth) {
    const wide = [...document.querySelectorAll("main *")].find(
      (element) => element.getBoundingClientRect().right > clientWidth + 1,
    );
    const where = wide ? `${wide.tagName.toLowerCase()}.${wide.className}` : "?";
    said.push(`sideways: ${scrollWidth - clientWidth} px too wide at ${clientWidth} px (${where})`);
  }
  for (const image of document.querySelectorAll("main article img[src]")) {
    if (!image.alt.trim()) said.push(`no alt text: ${image.getAttribute("src")}`);
    if (!image.naturalWidth) said.push(`empty image: ${image.src}`);
  }
  const views = document.querySelectorAll(widgets.views).length;
  const drawn = document.querySelectorAll(widgets.count).length;
  if (drawn < views) said.push(`widgets: ${drawn} of ${views} are drawn`);
  return said;
}

function report(name, found) {
  console.log(`${found.size ? "!!" : "ok"} ${name}`);
  for (const complaint of found) console.log(`   ${complaint}`);
  return found.size;
}
