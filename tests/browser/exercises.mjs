// Checks every exercise of a page with the answers of a plan: node exercises.mjs SITE PAGE PLAN
//
// PLAN is a file {setup, exercises: {name: {reference, wrong}}, completions: {name: {starter, whole,
// wrong}}}; `setup` is code that runs before.
// Without a plan only the starter of the first exercise is checked. Prints, per exercise, what was
// said to the starter, to the reference and to the wrong answer; and what went wrong on the page.

import { readFileSync } from "node:fs";
import { main, openPage } from "../../tools/browser.mjs";
import { check, listCompletions, listExercises, setCode } from "./_exercises.mjs";

await main(async (browser, site, name, planFile) => {
  const { page, complaints } = await openPage(browser, site, name);
  const names = await listExercises(page);
  const said = {};
  if (!planFile) {
    said[names[0]] = { starter: await check(page, names[0]) };
    return { said, complaints: [...complaints] };
  }
  const plan = JSON.parse(readFileSync(planFile, "utf8"));
  for (const exercise of names) said[exercise] = { starter: await check(page, exercise) };
  const setup = await check(page, names[0], plan.setup);
  const completed = {};
  const solved = () => page.locator(".exercise-count").innerText();
  for (const name of await listCompletions(page)) {
    const { starter, whole, wrong } = plan.completions[name];
    const before = await solved();
    completed[name] = {
      starter: await check(page, name),
      half: await check(page, name, starter.replace("= ...", "= 0")),
      wrong: await check(page, name, wrong),
      whole: await check(page, name, whole),
      next: await page.locator(`[data-exercise="${name}"] .exercise-on a`).innerText(),
      buttons: await page.locator(`[data-exercise="${name}"] button:visible`).allInnerTexts(),
      solved: [before, await solved()],
    };
  }
  for (const exercise of names) {
    const { reference, wrong } = plan.exercises[exercise];
    said[exercise].wrong = await check(page, exercise, wrong);
    said[exercise].reference = await check(page, exercise, reference);
    await setCode(page, exercise, "");
  }
  return { said, setup, completed, complaints: [...complaints] };
});
