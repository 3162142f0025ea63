// What a reader is to reach, how far it is, and that it is reached. A goal is a trait of the view
// (see labutils.explorers._goal): a sentence, and parts, each a value that the view tells and the
// limits it has to lie in. A view does nothing for it: its frame shows every value it tells.

import { make } from "./_elements.js";

const REACHED = "Reached";
const BEFORE = "Reached before";

/**
 * Make the line of a goal. `show` takes what the view tells, and `set` another goal, or none: {}.
 * @param {Element} parent
 * @param {Goal | Record<string, never> | undefined} goal
 */
export function makeGoal(parent, goal) {
  const root = make("div", "explorer-goal", parent);
  const aim = make("p", "explorer-goal-aim", root);
  const line = make("p", "explorer-goal-line", root);
  const bar = make("span", "explorer-goal-bar", line);
  bar.setAttribute("aria-hidden", "true");
  const fill = make("span", "", bar);
  const told = make("span", "explorer-goal-told", line);
  /** @type {HTMLElement[]} */
  let lines = [];
  const mark = make("span", "explorer-goal-mark", line);
  const spoken = make("p", "explorer-goal-spoken", root);
  spoken.setAttribute("role", "status");
  /** @type {Goal | null} */
  let current = null;
  /** @type {(number | null)[]} */
  let scales = [];
  let wasReached = false;

  /** @param {Goal | Record<string, never> | undefined} next */
  const set = (next) => {
    current = next && "parts" in next ? /** @type {Goal} */ (next) : null;
    scales = current?.parts.map(({ scale }) => scale) ?? [];
    wasReached = false;
    spoken.textContent = "";
    root.hidden = !current;
    root.dataset.state = "open";
    aim.textContent = "";
    if (!current) return;
    make("strong", "", aim).textContent = "Goal";
    aim.append(` ${current.text}`);
    told.replaceChildren();
    lines = current.parts.map(() => make("span", "", told));
  };
  set(goal);
  return {
    set,
    suspend(/** @type {boolean} */ isSuspended) {
      root.toggleAttribute("data-suspended", isSuspended);
    },
    /** @param {Record<string, any>} values */
    show(values) {
      if (!current) return;
      const shares = current.parts.map((part, place) => {
        const distance = findDistance(part, values[part.value]);
        // the bar is empty where the reader began
        scales[place] ??= distance || null;
        return distance === null ? 0 : 1 - Math.min(1, distance / (scales[place] ?? 1));
      });
      const share = Math.min(...shares);
      const isReached = share === 1;
      if (isReached && !wasReached) spoken.textContent = `${REACHED}: ${current.text}`;
      wasReached ||= isReached;
      const state = isReached ? "reached" : wasReached ? "before" : "open";
      if (root.dataset.state !== state) root.dataset.state = state;
      fill.style.width = `${(100 * share).toFixed(1)}%`;
      for (const [place, part] of current.parts.entries()) {
        lines[place].textContent = describe(part, values[part.value]);
      }
      mark.textContent = isReached ? REACHED : wasReached ? BEFORE : "";
    },
  };
}

/**
 * How far a value lies outside its limits; null where there is no value.
 * @param {GoalPart} part
 * @param {number | null | undefined} value
 */
function findDistance({ low, high }, value) {
  if (typeof value !== "number") return null;
  if (low !== null && value < low) return low - value;
  return high !== null && value > high ? value - high : 0;
}

/**
 * A value with its unit, and where it has to be.
 * @param {GoalPart} part
 * @param {number | null | undefined} value
 */
function describe({ name, low, high, unit, digits }, value) {
  const found = typeof value === "number" ? value.toFixed(digits) + unit : "none";
  const [from, to] = [low, high].map((one) => one?.toFixed(digits) ?? "");
  const wanted = from && to ? `${from} to ${to}` : from ? `at least ${from}` : `at most ${to}`;
  return `${name} ${found} (${wanted})`;
}
