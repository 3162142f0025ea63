// A warning where some lines begin with tabs and others with spaces, which Python refuses although
// it looks even. Tab itself puts in spaces: tabs come with pasted code.

import { syntaxTree } from "@codemirror/language";
import { StateField } from "@codemirror/state";
import { Decoration, EditorView, showPanel } from "@codemirror/view";
import { makePanel, say } from "./panels.js";

/** @typedef {import("@codemirror/state").EditorState} EditorState */
/** @typedef {import("@codemirror/state").Line} Line */

const STEP = 4;
const MAX_NAMED = 3;

const getIndent = (/** @type {Line} */ line) => /^[ \t]*/.exec(line.text)?.[0] ?? "";

/** Whether a line begins inside a text of several lines, where tabs do no harm. */
function isText(/** @type {EditorState} */ state, /** @type {Line} */ line) {
  const node = syntaxTree(state).resolveInner(line.from, 0);
  return /String$/.test(node.name) && node.from < line.from;
}

/**
 * The lines that begin with a tab, where others begin with a space.
 * @param {EditorState} state
 */
function findMixed(state) {
  /** @type {Line[]} */
  const tabbed = [];
  let hasSpaces = false;
  for (let number = 1; number <= state.doc.lines; number++) {
    const line = state.doc.line(number);
    const indent = getIndent(line);
    if (!indent || indent === line.text || isText(state, line)) continue;
    hasSpaces ||= indent.includes(" ");
    if (indent.includes("\t")) tabbed.push(line);
  }
  return hasSpaces ? tabbed : [];
}

/** @type {StateField<Line[]>} */
const mixed = StateField.define({
  create: findMixed,
  update: (lines, { docChanged, state }) => (docChanged ? findMixed(state) : lines),
  provide: (field) => [
    EditorView.decorations.from(field, (lines) =>
      Decoration.set(lines.map(({ from }) => mark.range(from))),
    ),
    showPanel.from(field, (lines) => (lines.length ? makeStrip : null)),
  ],
});
const mark = Decoration.line({ class: "cm-tabbedLine" });

/** Put spaces in place of the tabs at the beginning of lines. */
function useSpaces(/** @type {EditorView} */ view) {
  const changes = view.state.field(mixed).map((line) => {
    let indent = "";
    for (const sign of getIndent(line)) {
      indent += sign === "\t" ? " ".repeat(STEP - (indent.length % STEP)) : sign;
    }
    return { from: line.from, to: line.from + getIndent(line).length, insert: indent };
  });
  view.dispatch({ changes });
  view.focus();
}

function makeStrip(/** @type {EditorView} */ view) {
  const { dom, text, button } = makePanel("cm-mixed", () => useSpaces(view));
  text.setAttribute("role", "status");
  button.textContent = "Use spaces";
  const show = () => {
    const numbers = view.state.field(mixed).map(({ number }) => number);
    const named = numbers.slice(0, MAX_NAMED).join(", ");
    const more = numbers.length > MAX_NAMED ? ` and ${numbers.length - MAX_NAMED} more` : "";
    const subject = numbers.length > 1 ? `Lines ${named}${more} begin` : `Line ${named} begins`;
    say(text, `${subject} with tabs, others with spaces: Python takes one of the two.`);
  };
  show();
  return { dom, update: show };
}

export const mixedTabs = mixed;
