// What the scripts about exercise cells share: type code, check it, read what is said.

import { getText, setText } from "./_editors.mjs";

const LONGEST_MS = 300_000; // a boot on a machine that is busy

/** The element of one exercise. */
export const cell = (page, name) => page.locator(`.exercise[data-exercise="${name}"]`);

export const button = (page, name, text) =>
  cell(page, name).getByRole("button", { name: text, exact: true });

/** Replaces the code of an editor, as a reader who pastes. */
export const setCode = (page, name, text) =>
  setText(page, cell(page, name).locator(".cm-content"), text);

/** The whole code of an editor, also what is scrolled away: as a reader who copies. */
export const getCode = (page, name) => getText(page, cell(page, name).locator(".cm-content"));

/** Waits until no check of the exercise is under way; returns what it says. */
export async function settle(page, name) {
  await page.waitForFunction(
    (wanted) => document.querySelector(wanted).dataset.state === "idle",
    `.exercise[data-exercise="${name}"]`,
    { timeout: LONGEST_MS },
  );
  return read(page, name);
}

/** What an exercise says at the moment. */
export function read(page, name) {
  return cell(page, name).evaluate((element) => ({
    result: element.dataset.result,
    seconds: Number(element.dataset.seconds),
    status: element.querySelector(".exercise-status").textContent,
    text: element.querySelector(".exercise-output").innerText,
    pictures: element.querySelectorAll(".exercise-output img").length,
  }));
}

/** Clicks Check, waits, and returns what it says. */
export async function check(page, name, code = null) {
  if (code !== null) await setCode(page, name, code);
  await button(page, name, "Check").click();
  return settle(page, name);
}

/** Waits until the code itself runs. */
export function waitUntilItRuns(page, name) {
  return page.waitForFunction(
    (wanted) => document.querySelector(wanted).textContent === "Running",
    `.exercise[data-exercise="${name}"] .exercise-status`,
    { timeout: LONGEST_MS },
  );
}

/** Names of the exercises that have an editor. */
export const listExercises = (page) => listNames(page, ".exercise:not(.is-completion)");

/** Names of the completions, which come before their exercises. */
export const listCompletions = (page) => listNames(page, ".exercise.is-completion");

const listNames = (page, wanted) =>
  page.$$eval(`${wanted}[data-exercise]`, (all) => all.map((e) => e.dataset.exercise));
