// Runs cells of a page in Firefox: node cells_firefox.mjs SITE PAGE NUMBER; prints what was seen.

import { require } from "../../tools/browser.mjs";

const LONGEST_MS = 240_000;
const [site, name, number] = process.argv.slice(2);
const { launch } = require("puppeteer-core");

const browser = await launch({ browser: "firefox", executablePath: process.env.FIREFOX });
try {
  const page = await browser.newPage();
  const complaints = [];
  page.on("pageerror", (error) => complaints.push(/** @type {Error} */ (error).message));
  page.on("console", (m) => m.type() === "error" && complaints.push(m.text()));
  await page.goto(new URL(`${name}.html`, site).href);
  const run = `.cell-bar button[aria-label="Run cell ${number}"]`;
  await page.waitForSelector(run);
  // by keyboard: formulas that are still being set may move a button away from the mouse
  await page.focus(run);
  await page.keyboard.press("Enter");
  await page.waitForFunction(
    (place) => document.querySelectorAll(".cell.is-live")[place].dataset.result,
    { timeout: LONGEST_MS },
    Number(number) - 1,
  );
  const cells = await page.$$eval(".cell.is-live", (all) =>
    all.map((one) => ({
      result: /** @type {HTMLElement} */ (one).dataset.result ?? "",
      error: one.querySelector(".cell-error")?.textContent ?? "",
      pictures: one.querySelectorAll(".cell-yours > img, .cell-yours > .cell-html > svg").length,
      text: [...one.querySelectorAll(".cell-yours > .cell-text")].map((p) => p.textContent),
    })),
  );
  process.stdout.write(JSON.stringify({ cells: cells.slice(0, Number(number)), complaints }));
} finally {
  await browser.close();
}
