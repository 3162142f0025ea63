// Times Python in the page: node tools/bench/page_python.mjs HTML_FOLDER PAGE EXERCISE CODE TURNS
//
// Opens the page from a file, in Chromium (CHROMIUM names it), and checks the code. Prints JSON:
// milliseconds from the first click to the result, then of TURNS later checks.

import { existsSync } from "node:fs";
import { createRequire } from "node:module";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";

const require = createRequire(new URL("../../_build/npm/", import.meta.url));
const { chromium } = require("playwright-core");
const BROWSERS = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"];

const [folder, name, exercise, code, turns] = process.argv.slice(2);
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM || BROWSERS.find(existsSync),
  args: ["--no-sandbox"],
});
try {
  const page = await browser.newPage();
  await page.goto(new URL(`${name}.html`, pathToFileURL(`${resolve(folder)}/`)).href);
  await page.waitForSelector(".exercise .cm-line");
  const editor = page.locator(`.exercise[data-exercise="${exercise}"] .cm-content`);
  await editor.focus();
  await page.keyboard.press("ControlOrMeta+A");
  await editor.evaluate(paste, code);
  const times = await page.evaluate(measure, { exercise, turns: Number(turns) });
  process.stdout.write(JSON.stringify(times));
} finally {
  await browser.close();
}

/** Runs in the page: what a reader does who pastes. */
function paste(editor, text) {
  const clipboardData = new DataTransfer();
  clipboardData.setData("text/plain", text);
  editor.dispatchEvent(new ClipboardEvent("paste", { clipboardData, cancelable: true }));
}

/** Runs in the page: click, and wait until the result stands. */
async function measure({ exercise, turns }) {
  const cell = document.querySelector(`.exercise[data-exercise="${exercise}"]`);
  const turn = () =>
    new Promise((resolve) => {
      const started = performance.now();
      const observer = new MutationObserver(() => {
        if (cell.dataset.state !== "idle") return;
        observer.disconnect();
        // the result is drawn in the same task as the state
        requestAnimationFrame(() => resolve(performance.now() - started));
      });
      cell.querySelector("button.exercise-check").click();
      observer.observe(cell, { attributeFilter: ["data-state"] });
    });
  const first = await turn();
  const later = [];
  for (let i = 0; i < turns; i++) later.push(await turn());
  return { first, later, said: cell.dataset.result };
}
