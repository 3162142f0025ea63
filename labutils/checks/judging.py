"""Judge a function: the gates, the name of the mistake, the words and the picture.

Nothing here prints, stores, or looks at what a learner has done before: the same answers give the
same verdict, in a notebook, in the browser and in a grader.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from labutils.checks.calls import collect_answers, find_call_problem
from labutils.checks.compare import align_rows
from labutils.checks.explain import find_odd_case, find_relation
from labutils.checks.explain.probes import probe
from labutils.checks.gates import Failure, find_failure
from labutils.checks.kinds import get_kind
from labutils.checks.recognize import get_hint, recognize_mistakes
from labutils.checks.verdict import HIDDEN_CASES, NOT_YOURS, PanelPicture, Verdict

if TYPE_CHECKING:
    import numpy as np

    from labutils.checks.table import CheckTable, Outcome, Part


@dataclass(frozen=True)
class _FailedPart:
    """The part that failed, with what was due and what came."""

    part: Part
    due: np.ndarray
    yours: np.ndarray


def judge(table: CheckTable, function: object) -> Verdict:
    """Check a function against a table and keep no record of it.

    Parameters
    ----------
    table : CheckTable
        The cases, the answers due and the known wrong ones.
    function : object
        What a learner handed in; whatever is no function fails the first gate.

    Returns
    -------
    Verdict
        "not checked" where MuJoCo is missing or the checker itself fails: it raises nothing.
    """
    if problem := find_call_problem(table, function):
        return _fail(table, "defined", (problem,))
    assert callable(function)  # noqa: S101 - the first thing that find_call_problem asks for
    try:
        if table.needs_mujoco and not _has_mujoco():
            text = "This exercise needs MuJoCo, which this Python does not have (no browser does)."
            advice = "Open the page as a notebook, with its launch button or on your own computer."
            return Verdict(
                table.name, "not checked", paragraphs=(text, advice, NOT_YOURS), link=table.section
            )
        return judge_answers(table, collect_answers(table, function), function)
    except Exception as error:  # noqa: BLE001 - whatever fails here is the checker's own fault
        text = f"The checker itself failed: {type(error).__name__}: {error}."
        return Verdict(table.name, "not checked", paragraphs=(text, NOT_YOURS))


def _has_mujoco() -> bool:
    try:
        import mujoco  # noqa: F401, PLC0415 - only the exercises that need it pay for it
    except ImportError:
        return False
    return True


def judge_answers(
    table: CheckTable, answers: tuple[Outcome, ...], function: object = None
) -> Verdict:
    """Turn answers into a verdict: the gates, then the name of the mistake."""
    failure = find_failure(table, answers)
    if failure is None:
        lines = [f"All {len(table.cases)} visible cases agree."]
        borrowed = _is_library_function(table.name, function)
        if borrowed:
            lines.append("This is the function of labutils: write your own to earn the points.")
        paragraphs = (*lines, HIDDEN_CASES)
        return Verdict(table.name, "passed", paragraphs=paragraphs, counted=not borrowed)
    if failure.untouched:
        # Nothing was tried, so nothing is kept: a page may check its starters when it is built.
        verdict = _fail(table, failure.gate, ("Not started yet.", failure.text))
        return replace(verdict, counted=False)
    made = recognize_mistakes(table, answers)
    failed = _find_failed_part(table, answers, failure)
    told = [failure.text, _describe_where(table, failure, failed)]
    told += [f"Recognized: {text}" for text in get_hint(table, made)]
    verdict = _fail(table, failure.gate, tuple(told), made, _draw(failure, failed))
    return (
        verdict if made or failure.gate == "runs" else _explain(verdict, table, answers, function)
    )


def _explain(
    verdict: Verdict, table: CheckTable, answers: tuple[Outcome, ...], function: object
) -> Verdict:
    """Add what is seen of a mistake that has no name: the strongest that holds."""
    found = find_relation(table, answers)
    if found is None and callable(function) and (seen := probe(table, answers, function)):
        return replace(verdict, paragraphs=(*verdict.paragraphs, seen.say()), probe=seen.name)
    found = found or find_odd_case(table, answers)
    if found is None:
        return verdict
    return replace(verdict, paragraphs=(*verdict.paragraphs, found.say()), relation=found.name)


def _is_library_function(name: str, function: object) -> bool:
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


def _find_failed_part(
    table: CheckTable, answers: tuple[Outcome, ...], failure: Failure
) -> _FailedPart | None:
    """Return the part that failed, or None where there are not two values to look at."""
    due, yours = table.expected[failure.case], answers[failure.case]
    if not isinstance(due, tuple) or not isinstance(yours, tuple):
        return None
    yours = align_rows(table.parts, due, yours)
    x, y = due[failure.part], yours[failure.part]
    return None if x is None or y is None else _FailedPart(table.parts[failure.part], x, y)


def _describe_where(table: CheckTable, failure: Failure, failed: _FailedPart | None) -> str:
    """Name the case, and the worst place where there is one."""
    text = f"Case {failure.case + 1} of {len(table.cases)}: {table.cases[failure.case].label}."
    if failure.gate != "value" or failed is None:
        return text
    worst = get_kind(failed.part).describe_worst(failed.part, failed.due, failed.yours)
    return f"{text} {worst}" if worst else text


def _draw(failure: Failure, failed: _FailedPart | None) -> PanelPicture | None:
    if failure.gate not in ("range", "value", "shape") or failed is None:
        return None
    return get_kind(failed.part).draw(failed.part, failed.due, failed.yours)
