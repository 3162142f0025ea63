// The line after one that leaves its block (return, raise, ...) begins one step further out.

import { indentService, indentUnit, syntaxTree } from "@codemirror/language";

/** @typedef {import("@lezer/common").SyntaxNode} SyntaxNode */

const LEAVING = new Set([
  "ReturnStatement",
  "RaiseStatement",
  "PassStatement",
  "BreakStatement",
  "ContinueStatement",
]);
const OPEN = new Set(["(", "[", "{"]);
const CLOSED = new Set([")", "]", "}"]);

/**
 * The statement that leaves a block and begins a line; null where the line begins otherwise.
 * @param {import("@codemirror/state").EditorState} state
 * @param {number} from where the text of the line begins
 */
function findLeaving(state, from) {
  /** @type {SyntaxNode | null} */
  let node = syntaxTree(state).resolveInner(from, 1);
  while (node && node.from === from && !LEAVING.has(node.name)) node = node.parent;
  return node && node.from === from ? node : null;
}

/**
 * Whether a statement goes on behind a place: in brackets, in a text, behind a backslash.
 * @param {import("@codemirror/state").EditorState} state
 * @param {number} from
 * @param {number} to
 */
function isUnfinished(state, from, to) {
  let depth = 0;
  syntaxTree(state).iterate({
    from,
    to,
    enter({ name, to: end, from: start }) {
      if (start < from || start >= to) return;
      if (OPEN.has(name)) depth += 1;
      if (CLOSED.has(name)) depth -= 1;
      if (/String$/.test(name) && end > to) depth += 1;
    },
  });
  return depth > 0 || state.sliceDoc(from, to).trimEnd().endsWith("\\");
}

export const dedentAfterLeaving = indentService.of((context, pos) => {
  const { state, simulatedBreak } = context;
  if (simulatedBreak !== pos) return undefined; // no new line is being made
  const line = state.doc.lineAt(pos);
  const indent = line.text.length - line.text.trimStart().length;
  const from = line.from + indent;
  if (from >= pos || !findLeaving(state, from) || isUnfinished(state, from, pos)) return undefined;
  const columns = context.countColumn(line.text, indent);
  return Math.max(0, columns - state.facet(indentUnit).length);
});
