"""Mark the lines of the code on a page, so that a long one can wrap and show that it does.

A line that may not fit on a phone becomes a span with its own indentation; ``code.css`` hangs what
wraps below it, behind an arrow. The text stays as it was, character by character, for whoever
copies it and for the scripts that run it.
"""

import html
import re
from typing import Any

from sphinx.application import Sphinx

BLOCK = re.compile(r'(<div class="highlight"><pre>(?:<span></span>)?)(.*?)(</pre>)', re.DOTALL)
TAG = re.compile(r"<[^>]*>")
FITS = 30  # columns that the narrowest phone shows, in a box within a list


def mark_lines(
    _app: Sphinx, _pagename: str, _templatename: str, context: dict[str, Any], _doctree: object
) -> None:
    """Mark the long lines in the body of a page."""
    if "body" in context:
        context["body"] = BLOCK.sub(mark_block, context["body"])


def mark_block(block: re.Match[str]) -> str:
    """Mark the long lines of one block of code; leave one alone whose tags span lines."""
    lines = block[2].split("\n")
    if any(line.count("<span") != line.count("</span>") for line in lines):
        return block[0]
    return block[1] + "\n".join(mark_line(line) for line in lines) + block[3]


def mark_line(line: str) -> str:
    """Put a long line into a span that knows how far it is indented."""
    text = html.unescape(TAG.sub("", line))
    if len(text) <= FITS:
        return line
    indent = len(text) - len(text.lstrip(" "))
    style = f' style="--indent:{indent}"' if indent else ""
    return f'<span class="code-line"{style}>{line}</span>'


def setup(app: Sphinx) -> dict[str, Any]:
    """Connect the hook to Sphinx."""
    app.connect("html-page-context", mark_lines, priority=900)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
