// Where the time goes between the moment a picture is taken and the moment the neck has turned.

import { make } from "./_frame.js";

/**
 * Make the bar and its words.
 * @param {Element} parent
 */
export function makeBudget(parent) {
  const root = make("div", "explorer-budget", parent);
  const total = make("p", "explorer-budget-total", root);
  const bar = make("div", "explorer-budget-bar", root);
  bar.setAttribute("aria-hidden", "true");
  const list = make("ul", "explorer-budget-list", root);
  /** @type {{ part: HTMLElement, words: HTMLElement }[]} */
  const rows = [];
  return {
    /** @param {FollowingBudget[]} budget */
    show(budget) {
      const sum = budget.reduce((so_far, { ms }) => so_far + (ms ?? 0), 0);
      const more = budget.some(({ ms }) => ms === null) ? " and more" : "";
      total.textContent = `Picture to turn: ${sum.toFixed(0)} ms${more}`;
      budget.forEach(({ name, ms }, i) => {
        rows[i] ??= { part: make("span", "", bar), words: make("li", "", list) };
        rows[i].part.style.flexGrow = String(ms ?? 0);
        rows[i].words.textContent =
          ms === null ? `${name}: run to measure` : `${name} ${ms.toFixed(ms < 10 ? 1 : 0)} ms`;
      });
    },
  };
}
