// The line at which the reader's code stopped: marked until the next edit.

import { RangeSet, StateEffect, StateField } from "@codemirror/state";
import { Decoration, EditorView, GutterMarker, gutterLineClass, showPanel } from "@codemirror/view";
import { makePanel, say } from "./panels.js";

/** @typedef {import("@codemirror/state").EditorState} EditorState */

/** @type {import("@codemirror/state").StateEffectType<number | null>} */
const setFailed = StateEffect.define();

class FailedMarker extends GutterMarker {
  elementClass = "cm-failedGutter";
}
const marker = new FailedMarker();
const mark = Decoration.line({ class: "cm-failedLine" });

/** @type {StateField<number | null>} the number of the line */
const failed = StateField.define({
  create: () => /** @type {number | null} */ (null),
  update(line, { docChanged, effects, state }) {
    let next = docChanged ? null : line;
    for (const effect of effects) if (effect.is(setFailed)) next = effect.value;
    return next !== null && next >= 1 && next <= state.doc.lines ? next : null;
  },
  provide: (field) => [
    EditorView.decorations.from(field, (line) => (view) => {
      return line === null ? Decoration.none : Decoration.set(mark.range(getStart(view.state)));
    }),
    gutterLineClass.computeN([field], (state) => {
      if (state.field(field) === null) return [];
      return [rangeSet(state)];
    }),
    showPanel.from(field, (line) => (line === null ? null : makeStrip)),
  ],
});

function getStart(/** @type {EditorState} */ state) {
  return state.doc.line(state.field(failed) ?? 1).from;
}

function rangeSet(/** @type {EditorState} */ state) {
  return RangeSet.of([marker.range(getStart(state))]);
}

/** Below the code: which line, and the way there. */
function makeStrip(/** @type {EditorView} */ view) {
  const { dom, text, button } = makePanel("cm-failed", () => {
    view.dispatch({ selection: { anchor: getStart(view.state) }, scrollIntoView: true });
    view.focus();
  });
  const show = () => {
    const line = view.state.field(failed);
    say(text, `Stopped in line ${line}.`);
    say(button, `Go to line ${line}`);
  };
  show();
  return { dom, update: show };
}

/** Mark a line, or none. */
export function markLine(/** @type {EditorView} */ view, /** @type {number | null} */ line) {
  view.dispatch({ effects: setFailed.of(line) });
}

export const failedLine = failed;
