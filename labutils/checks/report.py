"""The page that says what is done, what is next, and which points are in reach."""

from __future__ import annotations

import html
from dataclasses import dataclass
from pathlib import Path

from labutils.checks.links import find_link
from labutils.checks.progress import Record, load_progress
from labutils.checks.progress_rules import MAX_HINTS
from labutils.checks.table import read_words
from labutils.checks.verdict import HIDDEN_CASES

#: Points for code quality: a reader gives them, no check does, and no card has them.
QUALITY_POINTS = 10


@dataclass(frozen=True)
class Row:
    """One line of the report."""

    chapter: str
    name: str
    title: str
    points: int
    state: str
    passed: bool
    hints: int
    section: str
    extension: bool = False


@dataclass(frozen=True)
class Report:
    """Progress as text in a terminal and as a table in Jupyter."""

    rows: tuple[Row, ...]
    notice: str = ""

    @property
    def points(self) -> int:
        """Points of the exercises whose visible cases agree."""
        return sum(row.points for row in self.rows if row.passed)

    @property
    def lab(self) -> tuple[Row, ...]:
        """The rows of the lab: exercises and challenges."""
        return tuple(row for row in self.rows if not row.extension)

    @property
    def extensions(self) -> tuple[Row, ...]:
        """The rows of chapters outside of the lab; they have no points."""
        return tuple(row for row in self.rows if row.extension)

    @property
    def next_row(self) -> Row | None:
        """The first exercise of the lab that is not done, else a challenge, else an extension."""
        left = [row for row in (*self.lab, *self.extensions) if not row.passed]
        return next((row for row in left if row.points), left[0] if left else None)

    @property
    def summary(self) -> tuple[str, ...]:
        """The sentences under the table."""
        lab = [row for row in self.lab if row.points]
        challenges = [row for row in self.lab if not row.points]
        total = sum(row.points for row in lab)
        done = sum(row.passed for row in lab)
        lines = [
            (
                f"Done: {done} of {len(lab)} exercises, {self.points} of {total} points in "
                f"reach so far, and {QUALITY_POINTS} more for code quality."
            ),
            (
                f"Challenges: {sum(row.passed for row in challenges)} of {len(challenges)}. They "
                "go beyond the lab and have no points."
            ),
            HIDDEN_CASES,
        ]
        if self.extensions:
            lines.insert(
                2,
                f"Extensions: {sum(row.passed for row in self.extensions)} of "
                f"{len(self.extensions)}. They are no part of the lab and have no points.",
            )
        row = self.next_row
        if row is None:
            lines.append("Next: nothing is left here.")
        else:
            lines.append(f"Next: {row.name} ({row.title}). Read: {row.section}")
        return (*lines, self.notice) if self.notice else tuple(lines)

    def __repr__(self) -> str:
        lines = [f"{'step':<5}{'exercise':<24}{'points':>6}  {'hints':<6}state"]
        lines += [
            f"{row.chapter:<5}{row.name:<24}{row.points or '-':>6}  "
            f"{row.hints}/{MAX_HINTS}   {row.state}"
            for row in self.lab
        ]
        if self.extensions:
            width = max(len("extension"), *(len(row.chapter) for row in self.extensions)) + 2
            lines += ["", f"{'extension':<{width}}{'exercise':<24}{'hints':<6}state"]
            lines += [
                f"{row.chapter:<{width}}{row.name:<24}{row.hints}/{MAX_HINTS}   {row.state}"
                for row in self.extensions
            ]
        return "\n".join([*lines, "", *self.summary])

    def _repr_html_(self) -> str:
        tables = _make_table("step", self.lab)
        if self.extensions:
            tables += _make_table("extension", self.extensions)
        notes = "".join(f"<p>{html.escape(line)}</p>" for line in self.summary)
        return f"{tables}{notes}"

    def to_page(self) -> str:
        """Return a whole HTML page that needs nothing else."""
        return (
            '<!doctype html>\n<html lang="en"><head><meta charset="utf-8">'
            '<meta name="viewport" content="width=device-width, initial-scale=1">'
            "<title>Lab progress</title><style>:root{color-scheme:light dark}"
            "body{font:1rem/1.5 system-ui,sans-serif;max-width:52rem;margin:2rem auto;"
            "padding:0 1rem}table{border-collapse:collapse;width:100%}"
            "td,th{padding:.3rem .6rem;border-bottom:1px solid #767b85}"
            "code,p{overflow-wrap:anywhere}"
            "@media(max-width:34rem){body{font-size:.85rem;padding:0 .5rem}"
            "td,th{padding:.3rem .2rem}}</style></head>"
            f"<body><h1>Lab progress</h1>{self._repr_html_()}</body></html>\n"
        )


def _make_table(first: str, rows: tuple[Row, ...]) -> str:
    """Return rows as an HTML table; those of extensions have no column of points."""
    has_points = first == "step"
    names = (first, "exercise", *(["points"] if has_points else []), "hints", "state")
    heads = "".join(f'<th scope="col" style="text-align:left">{name}</th>' for name in names)
    body = "".join(
        f"<tr><td>{html.escape(row.chapter)}</td>"
        f'<th scope="row" style="text-align:left;font-weight:normal">'
        f'<a href="{html.escape(row.section)}" style="color:inherit">'
        f"<code>{row.name}</code></a> "
        f"{html.escape(row.title)}</th>"
        + (f"<td>{row.points or '-'}</td>" if has_points else "")
        + f'<td>{row.hints}/{MAX_HINTS}</td><td style="text-align:left">'
        f"{html.escape(row.state)}</td></tr>"
        for row in rows
    )
    return f"<table><thead><tr>{heads}</tr></thead><tbody>{body}</tbody></table>"


def report(folder: str | Path | None = None) -> Report:
    """Show what is done, what is next and the points in reach.

    Parameters
    ----------
    folder : str or Path, optional
        Where ``labutils-progress.json`` lies; the working folder by default.

    Returns
    -------
    Report
        Shows itself as the last line of a cell; ``print`` it elsewhere.
    """
    progress = load_progress(None if folder is None else Path(folder))
    rows = []
    for name, words in read_words().items():
        record = progress.records.get(name)
        rows.append(
            Row(
                chapter=words["chapter"],
                name=name,
                title=words["title"],
                points=words["points"],
                state=_describe_state(record),
                passed=record is not None and record.passed,
                hints=record.hints if record else 0,
                section=find_link(words["section"]),
                extension=words["kind"] == "extension",
            )
        )
    return Report(tuple(rows), progress.notice)


def _describe_state(record: Record | None) -> str:
    if record is not None and record.passed:
        return "done"
    if record is None or not record.attempts:
        return "not started"
    return f"started, {record.attempts} {'check' if record.attempts == 1 else 'checks'}"
