// The docstring of a starter, folded to its first line, and a button that opens it. The text stays
// the same: folded lines are only not drawn.

import {
  codeFolding,
  ensureSyntaxTree,
  foldEffect,
  foldedRanges,
  foldKeymap,
  unfoldEffect,
} from "@codemirror/language";
import { keymap, showPanel } from "@codemirror/view";
import { makePanel, say } from "./panels.js";

/** @typedef {import("@codemirror/state").EditorState} EditorState */
/** @typedef {import("@codemirror/view").EditorView} EditorView */
/** @typedef {{from: number, to: number}} Range */

const PARSE_MS = 200; // a starter takes a few

/**
 * Where the first docstring of a function goes on behind its first line of words.
 * @param {EditorState} state
 * @returns {Range | null}
 */
function findRest(state) {
  const top = ensureSyntaxTree(state, state.doc.length, PARSE_MS)?.topNode;
  const body = top?.getChild("FunctionDefinition")?.getChild("Body");
  const first = body?.firstChild?.nextSibling; // behind the colon
  const text = first?.name === "ExpressionStatement" ? first.getChild("String") : null;
  if (!text) return null;
  let line = state.doc.lineAt(text.from);
  const hasWords = /\w/.test(line.text.slice(text.from - line.from + 3));
  if (!hasWords && line.to < text.to) line = state.doc.line(line.number + 1);
  return line.to < text.to ? { from: line.to, to: text.to } : null;
}

function countLines(/** @type {EditorState} */ state, /** @type {Range} */ { from, to }) {
  return state.doc.lineAt(to).number - state.doc.lineAt(from).number;
}

function isFolded(/** @type {EditorState} */ state, /** @type {Range} */ { from, to }) {
  let found = false;
  foldedRanges(state).between(from, to, () => {
    found = true;
  });
  return found;
}

/** The effects that fold the docstring of a text; none where there is nothing to fold. */
export function foldDocstring(/** @type {EditorState} */ state) {
  const rest = findRest(state);
  return rest && !isFolded(state, rest) ? [foldEffect.of(rest)] : [];
}

function toggle(/** @type {EditorView} */ view) {
  const rest = findRest(view.state);
  if (!rest) return;
  if (!isFolded(view.state, rest)) {
    view.dispatch({ effects: foldEffect.of(rest) });
    return;
  }
  /** @type {import("@codemirror/state").StateEffect<Range>[]} */
  const effects = [];
  foldedRanges(view.state).between(rest.from, rest.to, (from, to) => {
    effects.push(unfoldEffect.of({ from, to }));
  });
  view.dispatch({ effects });
}

const button = showPanel.of((view) => {
  const { dom, text, button } = makePanel("cm-docstring", () => toggle(view));
  text.remove();
  const show = () => {
    const rest = findRest(view.state);
    dom.hidden = !rest;
    if (!rest) return;
    const folded = isFolded(view.state, rest);
    say(button, folded ? "Show the whole docstring" : "Fold the docstring");
    button.setAttribute("aria-expanded", String(!folded));
  };
  show();
  return {
    dom,
    top: true,
    update({ docChanged, transactions }) {
      if (docChanged || transactions.some(({ effects }) => effects.length)) show();
    },
  };
});

export const docstringFolding = [
  codeFolding({
    preparePlaceholder: countLines,
    placeholderDOM(_view, onClick, count) {
      const mark = document.createElement("span");
      mark.className = "cm-foldPlaceholder";
      mark.textContent = `${count} more lines`;
      mark.title = "Show the whole docstring";
      mark.addEventListener("click", onClick);
      return mark;
    },
  }),
  keymap.of(foldKeymap),
  button,
];
