// The looks of what this editor adds to CodeMirror; the rest, and the colors, are exercises.css's.

import { EditorView } from "@codemirror/view";

export const theme = EditorView.theme({
  ".cm-panels": { background: "transparent", border: "0", color: "var(--ink-soft)" },
  ".cm-note": {
    alignItems: "center",
    display: "flex",
    flexWrap: "wrap",
    gap: "0.25rem 0.75rem",
    padding: "0.15rem 0.8rem",
  },
  ".cm-note[hidden]": { display: "none" },
  ".cm-note button": {
    background: "transparent",
    border: "0",
    color: "var(--accent)",
    cursor: "pointer",
    font: "inherit",
    minHeight: "2.75rem",
    padding: "0 0.25rem",
    textDecoration: "underline",
  },
  ".cm-failed, .cm-mixed": { borderLeft: "4px solid var(--failed)", color: "var(--ink)" },
  ".cm-failedLine": { background: "color-mix(in srgb, var(--failed) 14%, transparent)" },
  ".cm-tabbedLine": { background: "color-mix(in srgb, var(--failed) 8%, transparent)" },
  ".cm-gutterElement.cm-failedGutter": {
    color: "var(--failed)",
    fontWeight: "650",
    textDecoration: "underline",
  },
  ".cm-foldPlaceholder": {
    background: "transparent",
    border: "1px solid var(--control)",
    color: "var(--ink-soft)",
    cursor: "pointer",
    margin: "0 0.5em",
    padding: "0 0.4em",
  },
  ".cm-tooltip.cm-tooltip-autocomplete": {
    background: "var(--surface)",
    border: "1px solid var(--control)",
    color: "var(--ink)",
  },
  ".cm-tooltip.cm-tooltip-autocomplete > ul": {
    fontFamily: "var(--pst-font-family-monospace)",
    maxHeight: "14em",
    minWidth: "12em",
  },
  ".cm-tooltip.cm-tooltip-autocomplete > ul > li": { lineHeight: "1.5", padding: "0.1rem 0.5rem" },
  ".cm-tooltip.cm-tooltip-autocomplete ul li[aria-selected]": {
    background: "var(--accent)",
    color: "var(--accent-ink)",
  },
  ".cm-completionMatchedText": { fontWeight: "650", textDecoration: "none" },
});
