"""Check an exercise where it is written, and say which mistake was made.

    check("process_depth", process_depth)

Needs NumPy and OpenCV only, so it also runs in the browser; exercises that need MuJoCo say so
where it is missing. What is known of an exercise lies in frozen tables of outputs: no solution.
"""

from __future__ import annotations

from dataclasses import replace
from difflib import get_close_matches
from typing import Any

from labutils.checks.calls import collect_answers, find_call_problem
from labutils.checks.compare import align_rows
from labutils.checks.gates import Failure, find_failure
from labutils.checks.links import find_link
from labutils.checks.pictures import draw_comparison
from labutils.checks.progress import MAX_HINTS, Progress, load_progress, save_progress
from labutils.checks.recognize import get_hint, recognize_mistakes
from labutils.checks.report import Report, report
from labutils.checks.residuals import find_worst_pixel
from labutils.checks.table import CheckTable, Outcome, TableError, load_table, read_words
from labutils.checks.verdict import PanelPicture, Verdict

__all__ = ["Report", "Verdict", "check", "hint", "judge", "report"]

_HIDDEN_CASES = "These are the visible cases: hidden cases decide the grade."
_NOT_YOURS = "This is no mistake of yours, and nothing was counted."


def check(name: str, function: Any = None) -> Verdict:
    """Check a function against the visible cases of an exercise.

    Parameters
    ----------
    name : str
        The exercise, which is the name of the function it asks for.
    function : callable
        Your function itself, without parentheses.

    Returns
    -------
    Verdict
        Shows itself as the last line of a cell; ``print`` it elsewhere. It holds ``passed``,
        ``misconception``, ``property`` and ``message``. The result is kept in
        ``labutils-progress.json`` in the working folder.

    Raises
    ------
    ValueError
        If there is no exercise of that name.
    """
    try:
        known = read_words()
        if name not in known:
            raise ValueError(_describe_unknown(name, list(known)))
        verdict = judge(load_table(name), function)
    except TableError as error:
        return Verdict(str(name), "not checked", paragraphs=(f"{error}.", _NOT_YOURS))
    return _keep(replace(verdict, link=find_link(verdict.link)))


def _describe_unknown(name: object, known: list[str]) -> str:
    close = get_close_matches(str(name), known, n=1)
    wish = f" Did you mean {close[0]!r}?" if close else ""
    return f"exercise: expected one of {', '.join(known)}, got {name!r}.{wish}"


def judge(table: CheckTable, function: Any) -> Verdict:
    """Check a function against a table and keep no record of it."""
    if problem := find_call_problem(table, function):
        return _fail(table, "defined", (problem,))
    try:
        if table.needs_mujoco and not _has_mujoco():
            text = "This exercise needs MuJoCo, which this Python does not have (no browser does)."
            advice = "Open the page as a notebook, with its launch button or on your own computer."
            return Verdict(
                table.name, "not checked", paragraphs=(text, advice, _NOT_YOURS), link=table.section
            )
        return judge_answers(table, collect_answers(table, function), function)
    except Exception as error:  # noqa: BLE001 - whatever fails here is the checker's own fault
        text = f"The checker itself failed: {type(error).__name__}: {error}."
        return Verdict(table.name, "not checked", paragraphs=(text, _NOT_YOURS))


def _has_mujoco() -> bool:
    try:
        import mujoco  # noqa: F401, PLC0415 - only the exercises that need it pay for it
    except ImportError:
        return False
    return True


def judge_answers(table: CheckTable, answers: tuple[Outcome, ...], function: Any = None) -> Verdict:
    """Turn answers into a verdict: the gates, then the name of the mistake."""
    failure = find_failure(table, answers)
    if failure is None:
        lines = [f"All {len(table.cases)} visible cases agree."]
        borrowed = _is_library_function(table.name, function)
        if borrowed:
            lines.append("This is the function of labutils: write your own to earn the points.")
        paragraphs = (*lines, _HIDDEN_CASES)
        return Verdict(table.name, "passed", paragraphs=paragraphs, counted=not borrowed)
    if failure.untouched:
        # Nothing was tried, so nothing is kept: a page may check its starters when it is built.
        verdict = _fail(table, failure.gate, ("Not started yet.", failure.text))
        return replace(verdict, counted=False)
    made = recognize_mistakes(table, answers)
    told = [failure.text, _describe_where(table, answers, failure)]
    told += [f"Recognized: {text}" for text in get_hint(table, made)]
    return _fail(table, failure.gate, tuple(told), made, _draw(table, answers, failure))


def _is_library_function(name: str, function: Any) -> bool:
    module = getattr(function, "__module__", None) or ""
    return module.startswith("labutils.") and getattr(function, "__name__", "") == name


def _fail(
    table: CheckTable,
    gate: str,
    paragraphs: tuple[str, ...],
    made: tuple[str, ...] = (),
    picture: PanelPicture | None = None,
) -> Verdict:
    link = next((table.links[name] for name in made if name in table.links), table.section)
    return Verdict(table.name, "failed", gate, " + ".join(made) or None, paragraphs, link, picture)


def _describe_where(table: CheckTable, answers: tuple[Outcome, ...], failure: Failure) -> str:
    """Name the case, and the worst pixel where there is one."""
    text = f"Case {failure.case + 1} of {len(table.cases)}: {table.cases[failure.case].label}."
    part, due, yours = _get_failed_part(table, answers, failure)
    if failure.gate == "value" and part is not None and part.kind in ("rgb", "mapped", "depth"):
        worst = find_worst_pixel(part, due, yours)
        text += f" Worst pixel: (u, v) = {worst}." if worst else ""
    return text


def _get_failed_part(table: CheckTable, answers: tuple[Outcome, ...], failure: Failure) -> Any:
    """Return the part that failed with both values, or three times None."""
    due, yours = table.expected[failure.case], answers[failure.case]
    if not isinstance(due, tuple) or not isinstance(yours, tuple):
        return None, None, None
    yours = align_rows(table.parts, due, yours)
    x, y = due[failure.part], yours[failure.part]
    return (None, None, None) if x is None or y is None else (table.parts[failure.part], x, y)


def _draw(table: CheckTable, answers: tuple[Outcome, ...], failure: Failure) -> PanelPicture | None:
    part, due, yours = _get_failed_part(table, answers, failure)
    if failure.gate not in ("range", "value", "shape") or part is None:
        return None
    if part.kind in ("cloud", "rows", "pixels") and (
        yours.ndim != 2 or yours.shape[1:] != due.shape[1:]
    ):
        return None
    return draw_comparison(part, due, yours)


def _keep(verdict: Verdict) -> Verdict:
    """Write the verdict into the progress file; add a line where that goes wrong."""
    if verdict.result == "not checked" or not verdict.counted:
        return verdict
    progress = load_progress()
    record = progress.get(verdict.exercise)
    record.attempts += 1
    record.passed = record.passed or verdict.passed
    record.last_property = verdict.failed_gate
    if verdict.misconception:
        count = record.mistakes.get(verdict.misconception, 0)
        record.mistakes[verdict.misconception] = count + 1
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
        A str: hint 1, then 2, then 3 of 3; after that the third again.

    Raises
    ------
    ValueError
        If there is no exercise of that name.
    """
    known = read_words()
    if name not in known:
        raise ValueError(_describe_unknown(name, list(known)))
    progress = load_progress()
    record = progress.get(name)
    record.hints = min(record.hints + 1, MAX_HINTS)
    notices = _save(progress)
    text = f"Hint {record.hints} of {MAX_HINTS}: {known[name]['hints'][record.hints - 1]}"
    return Hint("\n".join([text, *notices]))
