// node jupyterlab.mjs SERVER NOTEBOOK EXERCISES ANSWER: opens a notebook in JupyterLab, runs it, moves
// a slider with the mouse and with the keyboard, turns the head in the live scene; then opens a page
// of exercises by a double click, checks a wrong answer and follows the link of its verdict. Prints
// what explorers, kernel and JupyterLab say. test_jupyterlab.py says what is right.

import { DESKTOP, main } from "../../tools/browser.mjs";

const START_MS = 120_000; // a cold JupyterLab on a busy machine
const STEP_MS = 60_000;

await main(async (browser, server, notebook, exercises, answer) => {
  const context = await browser.newContext({ viewport: DESKTOP });
  const page = await context.newPage();
  page.setDefaultTimeout(STEP_MS);
  await page.goto(new URL(`lab/tree/${notebook}`, server).href);
  await page.locator(".jp-Notebook .jp-CodeCell").first().waitFor({ timeout: START_MS });
  // what is run before the kernel has started is lost
  await page.getByText("| Idle").waitFor({ timeout: START_MS });
  await run(page, 0);
  const explorer = page.locator('.explorer[data-state="ready"]');
  await explorer.waitFor({ timeout: START_MS });
  const read = async () => {
    const python = await ask(page, 1); // first: by then the page has drawn, too
    return { python, page: await explorer.evaluate((one) => JSON.parse(one.dataset.parameters)) };
  };
  const before = await read();

  const handle = page.locator(".explorer-box .noUi-handle").first();
  await handle.scrollIntoViewIfNeeded();
  const from = await handle.boundingBox();
  const [x, y] = [from.x + from.width / 2, from.y + from.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 40, y, { steps: 4 });
  await page.mouse.up();
  const dragged = await read();

  await handle.focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  const pressed = await read();

  await page.locator(".explorer").getByRole("button", { name: "Reset" }).click();
  const reset = await read();
  const name = await handle.getAttribute("aria-label");
  const scene = await turnHead(page, 2);
  const chapter = await openChapter(
    page,
    new URL("lab/tree/exercises", server).href,
    exercises,
    answer,
  );
  await context.close();
  return { before, dragged, pressed, reset, name, scene, chapter };
});

/** Opens exercises by a double click, checks a wrong answer and follows the link of its verdict. */
async function openChapter(page, folder, exercises, answer) {
  await page.goto(`${folder}?reset`); // without the notebook that was open
  const files = page.locator(".jp-DirListing-itemText");
  await files.filter({ hasText: exercises }).dblclick();
  const cells = page.locator(".jp-Notebook .jp-CodeCell");
  await cells.first().waitFor();
  await page.getByText("| Idle").waitFor({ timeout: START_MS });
  const names = await files.allTextContents();
  await run(page, 0); // the tools of the page
  await cells.nth(2).locator(".cm-content").click();
  await page.keyboard.press("Control+a");
  await page.keyboard.insertText(answer);
  await run(page, 2);
  const verdict = cells.nth(2).locator(".jp-OutputArea-output");
  const link = verdict.locator("a");
  const seen = {
    names,
    cells: await cells.count(),
    notices: await page.locator(".Toastify__toast").allTextContents(),
    verdict: await verdict.innerText(),
    link: await link.textContent(),
  };
  await link.click();
  const title = page.locator(".jp-NotebookPanel:not(.lm-mod-hidden) h1", { hasText: /^Step/ });
  return { ...seen, followed: await title.textContent() };
}

/** Runs the live scene of a cell and drags its picture; the cell below says what Python knows. */
async function turnHead(page, place) {
  await run(page, place);
  const scene = page.locator(".explorer[data-frames]"); // Python has answered
  await scene.waitFor();
  const color = scene.locator("canvas").first();
  await color.scrollIntoViewIfNeeded();
  const box = await color.boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60, y + 30, { steps: 10 });
  await page.mouse.up();
  await page.waitForFunction(
    (one) => JSON.parse(one.dataset.values).is_current,
    await scene.elementHandle(),
  );
  const python = await ask(page, place + 1);
  return { python, page: JSON.parse(await scene.getAttribute("data-values")) };
}

/** Runs a cell and waits for its new number. */
async function run(page, place) {
  const getNumber = (at) =>
    document.querySelectorAll(".jp-CodeCell .jp-InputPrompt")[at]?.textContent ?? "";
  const old = await page.evaluate(getNumber, place);
  await page.locator(".jp-CodeCell").nth(place).locator(".cm-content").click();
  await page.keyboard.press("Control+Enter");
  const hasRun = ([at, before]) => {
    const now = document.querySelectorAll(".jp-CodeCell .jp-InputPrompt")[at]?.textContent ?? "";
    return /\[\d+\]/.test(now) && now !== before;
  };
  await page.waitForFunction(hasRun, [place, old]);
}

/** Runs a cell that prints JSON, and reads it. */
async function ask(page, place) {
  await page.waitForTimeout(500); // what the page changed reaches the kernel
  await run(page, place);
  const output = page.locator(".jp-CodeCell").nth(place).locator(".jp-OutputArea-output pre");
  return JSON.parse(await output.last().textContent());
}
