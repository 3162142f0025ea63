r"""Typeset formulas when the book is built, so that no reader waits for MathJax.

Each formula becomes a drawing with its MathML beside it for screen readers: it is there without
scripts and on paper, and costs a page a few kilobytes instead of a third of a megabyte. The TeX
stays in ``data-tex``, for the search.
"""

import json
import subprocess
import sys
from html import escape
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.errors import ExtensionError
from sphinx.util.math import get_node_equation_number
from sphinx.writers.html5 import HTML5Translator

COMMAND = ("-m", "tools.vendor.typeset")  # by its name: it stands in a room above this one
CLASSES = "math notranslate nohighlight"


class Typesetter:
    """MathJax in a process of its own, which starts with the first formula."""

    def __init__(self, folder: str) -> None:
        self._folder = folder
        self._process: subprocess.Popen[str] | None = None
        self._known: dict[str, str] = {}

    def visit_inline(self, translator: HTML5Translator, node: nodes.math) -> None:
        """Write a formula in a line of text."""
        tex = node.astext()
        given = {"CLASS": CLASSES, "data-tex": tex}
        drawn = self.typeset(tex, display=False)
        translator.body.append(f"{translator.starttag(node, 'span', '', **given)}{drawn}</span>")
        raise nodes.SkipNode

    def visit_block(self, translator: HTML5Translator, node: nodes.math_block) -> None:
        """Write a formula in lines of its own, with its number."""
        tex = node.astext().strip()
        given = {"CLASS": CLASSES, "data-tex": tex}
        translator.body.append(translator.starttag(node, "div", "", **given))
        if node["number"]:
            number = get_node_equation_number(translator, node)
            translator.body.append(f'<span class="eqno">({escape(number)})')
            translator.add_permalink_ref(node, "Link to this equation")
            translator.body.append("</span>")
        # as in sphinx.ext.mathjax: lines that end in \\ are set below each other
        whole = rf"\begin{{split}}{tex}\end{{split}}" if r"\\" in tex else tex
        translator.body.append(f"{self.typeset(whole, display=True)}</div>\n")
        raise nodes.SkipNode

    def typeset(self, tex: str, *, display: bool) -> str:
        """Return a formula as HTML.

        Raises
        ------
        ExtensionError
            If it is no TeX, or nothing typesets it.
        """
        asked = json.dumps({"tex": tex, "display": display})
        if asked not in self._known:
            said = self._ask(asked)
            if "html" not in said:
                got = said.get("error", "no answer; see tools/vendor/typeset.py")
                raise ExtensionError(
                    f"formula {tex!r}: expected TeX that MathJax knows, got: {got}"
                )
            self._known[asked] = said["html"]
        return self._known[asked]

    def close(self, _app: Sphinx, _exception: Exception | None) -> None:
        """End the process."""
        if self._process:
            self._process.communicate()
            self._process = None

    def _ask(self, asked: str) -> dict[str, str]:
        self._process = self._process or subprocess.Popen(  # noqa: S603 - our own command
            [sys.executable, *COMMAND],
            cwd=self._folder,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,  # MathJax complains of a component without a version
            encoding="utf-8",
        )
        given, told = self._process.stdin, self._process.stdout
        if not given or not told:
            return {}
        try:
            print(asked, file=given, flush=True)
            said: dict[str, str] = json.loads(told.readline() or "{}")
        except OSError:  # it has ended
            return {}
        return said


def setup(app: Sphinx) -> dict[str, Any]:
    """Name the renderer to Sphinx; ``html_math_renderer`` chooses it."""
    typesetter = Typesetter(str(app.srcdir))
    app.add_html_math_renderer(
        "drawn", (typesetter.visit_inline, None), (typesetter.visit_block, None)
    )
    app.connect("build-finished", typesetter.close)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": False}
