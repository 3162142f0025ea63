"""Judge a function: the gates, the name of the mistake, the words and the picture.

Nothing here prints, stores, or looks at what a learner has done before: the same answers give the
same verdict, in a notebook, in the browser and in a grader.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from labutils.checks.begun import count_open_lines, is_begun
from labutils.checks.calls import find_call_problem
from labutils.checks.compare import align_rows
from labutils.checks.explain import Differences
from labutils.checks.explain.probes import probe
from labutils.checks.explain.told import Explanation
from labutils.checks.gates import Failure, find_failure
from labutils.checks.inputs import collect_and_watch
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
    if table.open_lines and (left := count_open_lines(function)):
        return _tell_open_lines(table, left)
    try:
        if table.needs_mujoco and not _has_mujoco():
            text = (
                "This exercise needs MuJoCo, which this Python does not have: pip install mujoco."
            )
            advice = "Open the page as a notebook, with its launch button or on your own computer."
            return Verdict(
                table.name, "not checked", paragraphs=(text, advice, NOT_YOURS), link=table.section
            )
        answers, changed = collect_and_watch(table, function)
        verdict = judge_answers(table, answers, function, changed)
        # a completion is practice: nothing is kept of it
        return replace(verdict, counted=False) if table.leads_to else verdict
    except Exception as error:  # noqa: BLE001 - whatever fails here is the checker's own fault
        text = f"The checker itself failed: {type(error).__name__}: {error}."
        return Verdict(table.name, "not checked", paragraphs=(text, NOT_YOURS))


def _tell_open_lines(table: CheckTable, left: int) -> Verdict:
    """Name what is still missing in a completion."""
    begun = "One line is still open." if left < table.open_lines else "Not started yet."
    text = "Replace every ... by code: the comment behind it says what it has to be."
    return replace(_fail(table, "runs", (begun, text)), counted=False)


def _has_mujoco() -> bool:
    try:
        import mujoco  # noqa: F401, PLC0415 - only the exercises that need it pay for it
    except ImportError:
        return False
    return True


def judge_answers(
    table: CheckTable,
    answers: tuple[Outcome, ...],
    function: object = None,
    changed: tuple[str, ...] = (),
) -> Verdict:
    """Turn answers into a verdict: the gates, then what is seen of the mistake.

    Parameters
    ----------
    table : CheckTable
        The cases, the answers due and the known wrong ones.
    answers : tuple of Outcome
        What came, one per case.
    function : object
        The learner's, for probes; without it none is tried.
    changed : tuple of str
        The arguments that came back changed.

    Returns
    -------
    Verdict
        "passed" or "failed".
    """
    failure = find_failure(table, answers, begun=is_begun(function))
    if failure is None and changed:
        return _fail(table, "input", ("All values agree.", _tell_changed(changed).text))
    if failure is None and table.leads_to:
        lines = [f"All {len(table.cases)} cases agree.", f"Now write {table.leads_to} yourself."]
        return Verdict(table.name, "passed", paragraphs=tuple(lines), counted=False)
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
    verdict = replace(verdict, line=failure.line)
    if made or failure.gate == "runs":
        return verdict
    # The strongest that holds: a relation, what a probe shows, that of a part, the odd case.
    differences = Differences(table, answers)
    relation = differences.find_relation()
    shown = None
    if relation is None:
        shown = _tell_changed(changed) if changed else _probe(table, answers, function)
    if relation is None and shown is None:
        relation = differences.find_partial() or differences.find_odd_case()
    seen = tuple(one.say() for one in (relation, shown) if one)
    return replace(
        verdict,
        paragraphs=(*verdict.paragraphs, *seen),
        relation=relation.name if relation else None,
        probe=shown.name if shown else None,
    )


def _probe(table: CheckTable, answers: tuple[Outcome, ...], function: object) -> Explanation | None:
    is_repeatable = all(get_kind(part).is_repeatable for part in table.parts)
    return probe(table, answers, function) if callable(function) and is_repeatable else None


def _tell_changed(changed: tuple[str, ...]) -> Explanation:
    names = " and ".join(changed)
    belong = "belong" if len(changed) > 1 else "belongs"
    text = f"Your function changes {names}, which {belong} to whoever calls it: work on a copy."
    return Explanation(f"input:{'+'.join(changed)}", text)


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
    if failed is None or failure.gate not in get_kind(failed.part).properties:
        return text
    worst = get_kind(failed.part).describe_worst(failed.part, failed.due, failed.yours)
    return f"{text} {worst}" if worst else text


def _draw(failure: Failure, failed: _FailedPart | None) -> PanelPicture | None:
    if failed is None or failure.gate not in ("range", "shape", *get_kind(failed.part).properties):
        return None
    return get_kind(failed.part).draw(failed.part, failed.due, failed.yours)
