// The editor of the exercise cells: the entry that esbuild bundles into one script, whose global is
// `cameraLabEditor` (see tools/vendor/page_python.py). Colors are classes; exercises.css gives them.

import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import { pythonLanguage } from "@codemirror/lang-python";
import {
  bracketMatching,
  indentOnInput,
  indentUnit,
  syntaxHighlighting,
} from "@codemirror/language";
import { EditorState, Prec } from "@codemirror/state";
import { EditorView, highlightActiveLineGutter, keymap, lineNumbers } from "@codemirror/view";
import { classHighlighter } from "@lezer/highlight";
import { completion } from "./completion.js";
import { docstringFolding, foldDocstring } from "./docstring.js";
import { failedLine, markLine } from "./failed_line.js";
import { dedentAfterLeaving } from "./indent.js";
import { mixedTabs } from "./mixed_tabs.js";
import { theme } from "./theme.js";

// observers, not handlers: Escape may also end a selection, and then no handler after that is asked
const leaveWithTab = EditorView.domEventObservers({
  keydown(event, view) {
    if (event.key === "Escape") view.setTabFocusMode(true);
    else if (event.key !== "Tab" && event.key !== "Shift") view.setTabFocusMode(false);
  },
  blur: (_event, view) => view.setTabFocusMode(false),
});

/**
 * Make an editor for Python.
 *
 * Tab indents. Escape, then Tab, leaves the editor. CodeMirror allows two seconds for that, and
 * not while something is selected; here there is as much time as a reader needs.
 *
 * @param {object} options
 * @param {Element} options.parent
 * @param {string} options.text
 * @param {string} options.label for screen readers
 * @param {string} options.describedBy id of the line of help
 * @param {(text: string) => void} options.onChange after the reader edits
 * @param {() => void} options.onCheck for Ctrl or Cmd and Enter
 * @param {() => void} [options.onRun] for Shift and Enter; without it the same
 * @param {boolean} [options.folds] whether the docstring is folded to its first line
 */
export function createEditor({ folds = false, ...options }) {
  const { parent, text, label, describedBy, onChange, onCheck, onRun } = options;
  const keys = [
    { key: "Mod-Enter", act: onCheck },
    { key: "Shift-Enter", act: onRun ?? onCheck },
  ].map(({ key, act }) => ({
    key,
    run() {
      act();
      return true; // nobody else shall hear of this key
    },
  }));
  const view = new EditorView({
    parent,
    state: EditorState.create({
      doc: text,
      extensions: [
        lineNumbers(), // the lines a traceback names
        highlightActiveLineGutter(),
        history(),
        indentUnit.of("    "),
        indentOnInput(),
        dedentAfterLeaving,
        bracketMatching(),
        EditorView.lineWrapping, // a line that is cut off cannot be read on a phone
        pythonLanguage,
        completion,
        folds ? docstringFolding : [],
        failedLine,
        mixedTabs,
        theme,
        syntaxHighlighting(classHighlighter),
        Prec.highest(keymap.of(keys)),
        leaveWithTab,
        keymap.of([indentWithTab, ...defaultKeymap, ...historyKeymap]),
        EditorView.contentAttributes.of({
          "aria-label": label,
          "aria-describedby": describedBy,
          autocapitalize: "off",
          autocorrect: "off",
          spellcheck: "false",
          tabindex: "0", // it can be reached anyway; this says so to whoever inspects the page
        }),
        EditorView.updateListener.of((update) => {
          if (update.docChanged) onChange(update.state.doc.toString());
        }),
      ],
    }),
  });
  const fold = () => folds && view.dispatch({ effects: foldDocstring(view.state) });
  fold();
  return {
    getText: () => view.state.doc.toString(),
    setText(/** @type {string} */ value) {
      view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: value } });
      fold();
    },
    focus: () => view.focus(),
    markLine: (/** @type {number | null} */ line) => markLine(view, line),
  };
}
