// Names that the editor offers while somebody types: those of the code itself, its parameters among
// them, Python's own, and what NumPy and OpenCV have (tools/vendor/library_names.py lists them).
//
// Nothing is chosen until the reader chooses: Enter makes a new line, Tab after Escape leaves the
// editor, as without completion.

import {
  acceptCompletion,
  autocompletion,
  completionStatus,
  selectedCompletionIndex,
  setSelectedCompletion,
} from "@codemirror/autocomplete";
import { localCompletionSource } from "@codemirror/lang-python";
import { syntaxTree } from "@codemirror/language";
import { keymap } from "@codemirror/view";
import NAMES from "library-names";

/** @typedef {import("@codemirror/autocomplete").CompletionContext} Context */
/** @typedef {import("@codemirror/autocomplete").Completion} Completion */

const NO_CODE = new Set(["String", "FormatString", "Comment"]);
const MEMBER = /\b(?:np|numpy|cv2)\.(?:\w+\.)?\w*$/;
const WORD = /^\w*$/;

/** @type {Map<string, Completion[]>} */
const made = new Map();

/** What a module has; "python" for Python's own names. */
function listNames(/** @type {string} */ module) {
  let options = made.get(module);
  if (!options && NAMES[module]) {
    options = NAMES[module].split(" ").map((label) => ({ label, type: "name" }));
    made.set(module, options);
  }
  return options ?? [];
}

/** The node of the syntax tree that ends where somebody types. */
function getNode(/** @type {Context} */ { state, pos }) {
  return syntaxTree(state).resolveInner(pos, -1);
}

/** Names of a module, behind its dot. */
function completeMember(/** @type {Context} */ context) {
  const found = context.matchBefore(MEMBER);
  if (!found || NO_CODE.has(getNode(context).name)) return null;
  const dot = found.text.lastIndexOf(".");
  const module = found.text.slice(0, dot).replace(/^numpy\b/, "np");
  const options = listNames(module);
  return options.length ? { from: found.from + dot + 1, options, validFor: WORD } : null;
}

/** Python's own names. */
function completeName(/** @type {Context} */ context) {
  const found = context.matchBefore(/[\w.]+$/);
  const isWord = found && /^[A-Za-z_]\w*$/.test(found.text);
  if (NO_CODE.has(getNode(context).name) || (found && !isWord)) return null;
  if (!found && !context.explicit) return null;
  return { from: found?.from ?? context.pos, options: listNames("python"), validFor: WORD };
}

/** Tab takes what is chosen; where nothing is, the first. */
function takeCompletion(/** @type {import("@codemirror/view").EditorView} */ view) {
  if (completionStatus(view.state) !== "active") return false;
  if (selectedCompletionIndex(view.state) === null) {
    view.dispatch({ effects: setSelectedCompletion(0) });
  }
  return acceptCompletion(view);
}

export const completion = [
  autocompletion({
    override: [localCompletionSource, completeMember, completeName],
    selectOnOpen: false,
    icons: false,
  }),
  keymap.of([{ key: "Tab", run: takeCompletion }]),
];
