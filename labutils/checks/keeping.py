"""What a learner calls: check a function and ask for a hint. Both are kept beside the notebook."""

from __future__ import annotations

from dataclasses import replace
from difflib import get_close_matches
from typing import Any

from labutils.checks.judging import judge
from labutils.checks.links import find_link
from labutils.checks.progress import Progress, load_progress, save_progress
from labutils.checks.progress_rules import MAX_HINTS
from labutils.checks.table import TableError, load_table, read_completions, read_words
from labutils.checks.verdict import NOT_YOURS, Verdict


def check(name: str, function: object = None) -> Verdict:
    """Check a function against the visible cases of an exercise.

    Parameters
    ----------
    name : str
        The exercise, which is the name of the function it asks for; or a completion.
    function : callable
        Your function itself, without parentheses.

    Returns
    -------
    Verdict
        Shows itself as the last line of a cell; ``print`` it elsewhere. It holds ``passed``,
        ``misconception``, ``relation``, ``probe``, ``property`` and ``message``. The result is kept
        in ``labutils-progress.json`` in the working folder.

    Raises
    ------
    ValueError
        If there is no exercise of that name.
    """
    try:
        if name not in read_completions():
            _read_exercise(name)
        verdict = judge(load_table(name), function)
    except TableError as error:
        return Verdict(str(name), "not checked", paragraphs=(f"{error}.", NOT_YOURS))
    return _keep(replace(verdict, link=find_link(verdict.link)))


def _read_exercise(name: str) -> dict[str, Any]:
    """Return the words of an exercise; raise ValueError, with a wish, where there is none."""
    known = read_words()
    if name in known:
        return dict(known[name])
    close = get_close_matches(str(name), list(known), n=1)
    wish = f" Did you mean {close[0]!r}?" if close else ""
    raise ValueError(f"exercise: expected one of {', '.join(known)}, got {name!r}.{wish}")


def _keep(verdict: Verdict) -> Verdict:
    """Write the verdict into the progress file; add a line where that goes wrong."""
    if verdict.result == "not checked" or not verdict.counted:
        return verdict
    progress = load_progress()
    record = progress.get(verdict.exercise)
    record.attempts += 1
    record.passed = record.passed or verdict.passed
    record.last_property = verdict.failed_gate
    for name, counts in (
        (verdict.misconception, record.mistakes),
        (verdict.relation, record.relations),
        (verdict.probe, record.probes),
    ):
        if name:
            counts[name] = counts.get(name, 0) + 1
    notices = _save(progress)
    if not notices:
        return verdict
    # The last line of a pass stays last.
    *first, last = verdict.paragraphs
    return replace(verdict, paragraphs=(*first, *notices, last))


def _save(progress: Progress) -> list[str]:
    """Write the progress file; return what went wrong in reading or writing it, in words."""
    return [text for text in (progress.notice, save_progress(progress)) if text]


class Hint(str):
    """A text that shows itself without quotation marks."""

    __slots__ = ()

    def __repr__(self) -> str:
        return str(self)


def hint(name: str) -> Hint:
    """Give the next hint for an exercise, and count it.

    Parameters
    ----------
    name : str
        The exercise.

    Returns
    -------
    Hint
        A str: hint 1, then 2, then 3 of 3; after that the third again. For a completion, where
        its worked example is.

    Raises
    ------
    ValueError
        If there is no exercise of that name.
    """
    if (completion := read_completions().get(name)) is not None:
        link = find_link(completion["section"])
        return Hint(f"A completion has no hints. Its worked example shows every call: {link}")
    hints = _read_exercise(name)["hints"]
    progress = load_progress()
    record = progress.get(name)
    record.hints = min(record.hints + 1, MAX_HINTS)
    notices = _save(progress)
    text = f"Hint {record.hints} of {MAX_HINTS}: {hints[record.hints - 1]}"
    return Hint("\n".join([text, *notices]))
