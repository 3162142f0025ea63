"""Sentences for code that Python cannot read: SyntaxError, IndentationError, TabError."""

from __future__ import annotations

import linecache
import re
from keyword import kwlist

#: Looked for in the line that Python names: what other languages write, and what Python writes.
_OTHER_LANGUAGES = (
    (r"\belse\s+if\b", "Python writes elif for else if."),
    (r"&&", "Python writes and for &&; for arrays & with brackets around both sides."),
    (r"\|\|", "Python writes or for ||; for arrays | with brackets around both sides."),
    (r"(\+\+|--)\s*(;|$)", "Python has no ++ or --: write += 1 or -= 1."),
    (r"^\s*[%!]", "Lines with % or ! work in notebooks only, where no Python reads them."),
    (r"^\s*function\b", "Python writes def for function."),
    (
        rf"(?:^|,)\s*(?:{'|'.join(kwlist)})\s*=(?!=)",
        "A word of Python's own (class, lambda, in, ...) is no name for a value: choose another.",
    ),
)

_MIXED = "Tabs and spaces are mixed: use four spaces for each step in."

_SENTENCES = (
    (
        r"expected ':'",
        "A line that begins a block (def, if, else, for, while, with) ends with a colon.",
    ),
    (
        r"'([(\[{])' was never closed",
        "Line {line} opens a {0} that nothing closes: count its brackets.",
    ),
    (
        r"unmatched '([)\]}])'",
        "This {0} closes nothing that is open: count the brackets of the line.",
    ),
    (
        r"closing parenthesis '(.)' does not match opening parenthesis '(.)'",
        "A {1} is open, and a {0} comes to close it: brackets are closed in reverse order.",
    ),
    (
        r"unterminated (?:triple-quoted )?(?:f-)?string literal",
        "A text is opened by a quote and not closed by the same one.",
    ),
    (r"unterminated triple-quoted", "A text that three quotes open ends with three quotes."),
    (
        r"expected an indented block after (.+) on line (\d+)",
        "What belongs to the {0} of line {1} has to be indented, by four spaces.",
    ),
    (
        r"unexpected indent",
        "Nothing asks for this step in: one follows only a line that ends with a colon.",
    ),
    (
        r"unindent does not match",
        "This line is indented like none of the blocks around it: use four spaces each.",
    ),
    (r"inconsistent use of tabs", _MIXED),
    (
        r"Maybe you meant '==' or ':=' instead of '='",
        "= gives a value to a name; == asks whether two are equal.",
    ),
    (
        r"cannot assign to (?:attribute|subscript|name) here",
        "= gives a value to a name; == asks whether two are equal.",
    ),
    (
        r"cannot assign to (function call|expression|literal|comparison)",
        "The left side of = has to be a name, an item or a field, and this is a {0}.",
    ),
    (
        r"Perhaps you forgot a comma",
        "Two things follow each other without a comma or an operator (such as *).",
    ),
    (r"invalid decimal literal", "A name cannot begin with a digit, and a product needs *: 2 * x."),
    (
        r"'(return|yield|await)' outside function",
        "{0} belongs into a function: is its line indented like the others?",
    ),
    (
        r"'(break|continue)' outside loop|'(break|continue)' not properly in loop",
        "break and continue belong into a loop.",
    ),
    (r"Missing parentheses in call to 'print'", "print is a function: print(...)."),
    (
        r"invalid character '(.)'|invalid non-printable character (U\+\w+)",
        "One character is none of Python's (copied text has such quotes and spaces): type it anew.",
    ),
    (
        r"positional argument follows keyword",
        "Arguments with a name (name=value) come after those without.",
    ),
    (r"keyword argument repeated", "An argument with one name can be given once."),
    (r"leading zeros", "Whole numbers do not begin with 0."),
    (
        r"parameter without a default follows|non-default argument follows",
        "Parameters with a default come last.",
    ),
    (r"f-string", "Something between {{ and }} of this f-string cannot be read."),
)


def explain_syntax(error: SyntaxError) -> str:
    """Say what Python's complaint about a line means."""
    line, message = error.text or "", error.msg or ""
    if message.startswith(("invalid syntax", "expected ':'")):
        for pattern, sentence in _OTHER_LANGUAGES:
            if re.search(pattern, line.split("#")[0].rstrip()):
                return sentence
    if isinstance(error, IndentationError) and _mixes_tabs(error):
        return _MIXED
    for pattern, sentence in _SENTENCES:
        found = re.search(pattern, message)
        if found:
            return sentence.format(*found.groups(), line=error.lineno)
    return "Python reads the code up to the mark ^: look there, and at the end of the line before."


def _mixes_tabs(error: SyntaxError) -> bool:
    """Tell whether some lines are indented with tabs and some with spaces: it looks even."""
    lines = linecache.getlines(error.filename or "") or [error.text or ""]
    indents = "".join(line[: len(line) - len(line.lstrip())] for line in lines if line.strip())
    return "\t" in indents and " " in indents
