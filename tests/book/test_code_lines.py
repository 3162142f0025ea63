"""The hook that marks long lines of code keeps the code."""

from __future__ import annotations

import html
import re

import pytest

from tests.helpers.scripts import load_script

hook = load_script("book/_ext/code_lines.py")
LONG = "        value = compute(first_argument, second_argument)  # a < b"
CODE = f'def f():\n    """Long text\n\n    over some lines, long enough to be wrapped."""\n{LONG}\n'


def mark(code: str) -> str:
    """Return the page that the hook makes of a page with this code."""
    lines = "\n".join(f'<span class="n">{html.escape(line)}</span>' for line in code.split("\n"))
    context = {"body": f'<div class="highlight"><pre><span></span>{lines}</pre></div>'}
    hook.mark_lines(None, "", "", context, None)
    return str(context["body"])


def test_no_character_of_the_code_changes() -> None:
    plain = html.unescape(re.sub(r"<[^>]*>", "", mark(CODE)))
    assert plain.strip("\n") == CODE.strip("\n")


def test_a_long_line_is_marked_with_its_indentation_and_a_short_one_is_not() -> None:
    made = mark(CODE)
    assert made.count('class="code-line"') == 2
    assert '<span class="code-line" style="--indent:8">' in made
    assert '<span class="code-line" style="--indent:4">' in made


def test_an_escaped_character_counts_as_one() -> None:
    assert "code-line" not in mark("<" * hook.FITS)
    assert "code-line" in mark("<" * (hook.FITS + 1))


@pytest.mark.parametrize("body", ["<p>no code</p>", "<pre>" + "x" * 99 + "</pre>"])
def test_what_is_no_highlighted_code_stays_as_it_is(body: str) -> None:
    context = {"body": body}
    hook.mark_lines(None, "", "", context, None)
    assert context["body"] == body


def test_a_block_whose_tags_span_lines_stays_as_it_is() -> None:
    body = f'<div class="highlight"><pre><span class="hll">{LONG}\n{LONG}\n</span></pre></div>'
    context = {"body": body}
    hook.mark_lines(None, "", "", context, None)
    assert context["body"] == body
