// Typesets formulas for the book: a line of JSON in, {tex, display}; a line out, {html} or {error}.
// book/_ext/formulas.py asks through typeset.py.

import { createInterface } from "node:readline";

import { require } from "../browser.mjs";

const MathJax = await require("mathjax").init({
  loader: { load: ["input/tex", "output/svg", "adaptors/liteDOM", "a11y/assistive-mml"] },
  // no ids, which a copy of a formula would say twice; as large as the letters around it
  svg: { fontCache: "none", scale: 0.94, displayAlign: "left", displayIndent: "1.5em" },
  startup: { typeset: false },
});
const { adaptor } = MathJax.startup;

for await (const line of createInterface({ input: process.stdin })) {
  const { tex, display } = JSON.parse(line);
  const html = adaptor.outerHTML(MathJax.tex2svg(tex, { display }));
  const [, error] = html.match(/data-mjx-error="([^"]*)"/) ?? [];
  process.stdout.write(`${JSON.stringify(error ? { error } : { html })}\n`);
}
