// Runs cells whose outputs are covered: node predict_run.mjs SITE; prints what was seen.

import { main, newPage, settle } from "../../tools/browser.mjs";
import * as ui from "./_cells.mjs";

await main(async (browser, site) => {
  const { page, complaints } = await newPage(browser, site);
  await page.goto(new URL("book/step1_camera.html", site).href);
  await settle(page);
  const isAsked = (cells) => cells.findIndex((one) => one.matches(".predict-answer-row-first"));
  const covered = 1 + (await page.$$eval(".cell.is-live", isAsked));
  const look = () =>
    ui.cell(page, covered).evaluate((cell) => ({
      isCovered: cell.classList.contains("is-covered"),
      seen: [...cell.querySelectorAll(".cell-yours, .cell_output > *")].some((one) =>
        one.checkVisibility({ contentVisibilityAuto: true }),
      ),
    }));
  await ui.run(page, covered + 1); // which runs the covered one before
  const below = { ...(await look()), result: (await ui.readCells(page))[covered - 1].result };
  await ui.run(page, covered);
  const said = await page.locator("#predict-row-first .predict-result").textContent();
  return { below, itself: await look(), said, complaints: [...complaints] };
});
