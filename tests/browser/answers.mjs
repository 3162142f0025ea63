// Runs pieces of code in the editors of a page, one after the other: node answers.mjs SITE PAGE PLAN
//
// PLAN is a file {setup, runs: [{exercise, code}]}; `setup` is code that runs before, in the editor
// of the first. Prints what was said to each, and what went wrong on the page.

import { readFileSync } from "node:fs";
import { main, openPage } from "../../tools/browser.mjs";
import { check } from "./_exercises.mjs";

await main(async (browser, site, name, planFile) => {
  const { page, complaints } = await openPage(browser, site, name);
  const plan = JSON.parse(readFileSync(planFile, "utf8"));
  const setup = await check(page, plan.runs[0].exercise, plan.setup);
  const said = [];
  for (const { exercise, code } of plan.runs) said.push((await check(page, exercise, code)).text);
  return { setup: setup.text, said, complaints: [...complaints] };
});
