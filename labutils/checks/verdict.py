"""The record of one check. Everything that shows it only reads it."""

from __future__ import annotations

import base64
import html
import textwrap
from dataclasses import dataclass
from typing import Literal

from labutils.checks.links import name_link

#: Columns of a message; a notebook on a phone breaks them once more.
WIDTH = 96

#: A verdict is read at a glance, so it stays below this many lines.
MAX_LINES = 11

#: A pass is none of the grade, so whoever tells of passes says this.
HIDDEN_CASES = "These are the visible cases: hidden cases decide the grade."

#: What is said wherever the checker cannot judge.
NOT_YOURS = "This is no mistake of yours, and nothing was counted."

Result = Literal["passed", "failed", "not checked"]

_MARKS: dict[Result, tuple[str, str]] = {
    "passed": ("passed", "#009E73"),
    "failed": ("not yet", "#D55E00"),
    "not checked": ("not checked", "#767b85"),
}


@dataclass(frozen=True)
class PanelPicture:
    """Expected, yours and their difference side by side, as PNG."""

    png: bytes
    summary: str


@dataclass(frozen=True)
class Verdict:
    """What `check` found.

    Parameters
    ----------
    exercise : str
        Name of the exercise.
    result : str
        "passed", "failed", or "not checked": the checker could not judge, and nobody is blamed.
    failed_gate : str or None
        The first gate that failed, also called `property`: defined, runs, type, shape, dtype,
        range, value, or input where all is right but arguments came back changed.
    misconception : str or None
        Name of the recognized mistake; two are joined by " + ".
    relation : str or None
        Where no mistake is recognized: how what came follows from what was due, in all cases,
        such as "scaled:1000:depth"; several are joined by "+".
    probe : str or None
        Where there is no relation either: what calling the function again showed, such as
        "no-effect:max_depth" or "input:depth_metric".
    paragraphs : tuple of str
        The message after its headline.
    link : str
        Where to read again, relative to a page of the book; empty for none.
    picture : PanelPicture or None
        For pictures, depth, masks and clouds.
    counted : bool
        False where the result says nothing about the learner: nothing is kept of it.
    line : int or None
        The line of the learner's file or cell where the function stopped, if it did.
    """

    exercise: str
    result: Result
    failed_gate: str | None = None
    misconception: str | None = None
    paragraphs: tuple[str, ...] = ()
    link: str = ""
    picture: PanelPicture | None = None
    counted: bool = True
    relation: str | None = None
    probe: str | None = None
    line: int | None = None

    @property
    def passed(self) -> bool:
        """True only where every visible case agrees."""
        return self.result == "passed"

    @property
    def is_begun(self) -> bool:
        """False for a starter that nobody has touched: it fails, and nothing is counted."""
        return self.result != "failed" or self.counted

    @property
    def headline(self) -> str:
        """The first line."""
        gate = f" ({self.failed_gate})" if self.failed_gate else ""
        return f"{self.exercise}: {_MARKS[self.result][0]}{gate}"

    @property
    def message(self) -> str:
        """The whole text, fewer than 12 lines."""
        lines = [self.headline]
        for paragraph in self._get_all_paragraphs():
            lines += textwrap.wrap(paragraph, WIDTH, break_long_words=False, break_on_hyphens=False)
        if len(lines) > MAX_LINES:  # a long exception text: its end is the least of the message
            lines = [*lines[: MAX_LINES - 2], "...", lines[-1]]
        return "\n".join(lines)

    def _get_all_paragraphs(self) -> tuple[str, ...]:
        return (*self.paragraphs, f"Read again: {self.link}") if self.link else self.paragraphs

    def _repr_html_(self) -> str:
        """Return the same words with a color, and the picture."""
        body = "".join(f"<div>{html.escape(text)}</div>" for text in self.paragraphs)
        if self.link:
            target = html.escape(self.link)
            name = html.escape(name_link(self.link))
            body += f'<div>Read again: <a href="{target}" style="color:inherit">{name}</a></div>'
        # what nobody has begun is no mistake, and looks like none
        color = _MARKS[self.result if self.is_begun else "not checked"][1]
        begun = "" if self.is_begun else ' data-begun="false"'
        return (
            f'<div{begun} style="border-left:4px solid {color};padding:0.1em 0.8em;margin:0.4em 0">'
            f'<div><strong style="color:inherit">{html.escape(self.headline)}</strong></div>'
            f"{body}{self._get_picture_html()}</div>"
        )

    def _get_picture_html(self) -> str:
        if self.picture is None:
            return ""
        data = base64.b64encode(self.picture.png).decode("ascii")
        return (
            f'<img src="data:image/png;base64,{data}" alt="{html.escape(self.picture.summary)}" '
            'style="max-width:100%;height:auto;margin-top:0.4em">'
        )

    def __repr__(self) -> str:
        return self.message

    # The last of the class: below this line the word no longer means Python's decorator.
    @property
    def property(self) -> str | None:
        """The first property that does not hold, or None."""
        return self.failed_gate
