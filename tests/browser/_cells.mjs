// What the scripts about code cells share: run one, run all, read what they show.

import { setText } from "./_editors.mjs";

const LONGEST_MS = 300_000; // a whole page on a machine that is busy

/** The cell with a number, as a tab knows it. */
export const cell = (page, number) => page.locator(".cell.is-live").nth(number - 1);

export const button = (page, number, text) =>
  cell(page, number)
    .locator(".cell-bar")
    .getByRole("button", { name: `${text} cell ${number}` });

/** Presses "Run all" and waits until the page has run. */
export async function runAll(page) {
  await page.locator(".cells-bar").getByRole("button", { name: "Run all" }).click();
  await page.waitForFunction(
    () => document.querySelector(".cells-bar .cell-run").textContent === "Run all",
    null,
    { timeout: LONGEST_MS },
  );
}

/** Waits until nothing that was begun with a cell runs any more; returns what it shows. */
export async function settle(page, number) {
  await page.waitForFunction(
    (place) => {
      const one = document.querySelectorAll(".cell.is-live")[place];
      return one.getAttribute("aria-busy") === "false";
    },
    number - 1,
    { timeout: LONGEST_MS },
  );
  return (await readCells(page))[number - 1];
}

/** Presses Run, waits, and returns what the cell shows. */
export async function run(page, number) {
  await button(page, number, "Run").click();
  return settle(page, number);
}

/** Opens the editor of a cell and replaces its code, as a reader who pastes. */
export async function edit(page, number, text) {
  const edit = button(page, number, "Edit");
  if (await edit.isVisible()) await edit.click();
  const editor = cell(page, number).locator(".cm-content");
  await editor.waitFor();
  await setText(page, editor, text);
}

/** What every cell of a page shows at the moment. */
export function readCells(page) {
  return page.$$eval(".cell.is-live", (all) =>
    all.map((one) => ({
      result: one.dataset.result ?? "",
      status: one.querySelector(".cell-status").textContent,
      text: [...one.querySelectorAll(".cell-yours > .cell-text:not(.cell-warning)")]
        .map((part) => part.textContent)
        .join("\n"),
      warnings: [...one.querySelectorAll(".cell-yours > .cell-warning")].map((p) => p.textContent),
      error: one.querySelector(".cell-error")?.textContent ?? "",
      pictures: one.querySelectorAll(".cell-yours > img, .cell-yours > .cell-html > svg").length,
      builtPictures: one.querySelectorAll(".cell_output img:not(.explorer-poster)").length,
      widgets: one.querySelectorAll(".cell-yours .cell-widget").length,
      isYoursShown: !one.querySelector(".cell-yours").hidden,
      isBuiltShown: Boolean(one.querySelector(".cell_output:not(.is-replaced)")),
    })),
  );
}
