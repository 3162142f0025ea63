"""Write what is said of the exercises of a chapter: card, headings of groups, facts, links."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tools.derive.difficulty import rate_exercise

if TYPE_CHECKING:
    from collections.abc import Iterable

    from content.chapters import Chapter
    from solutions import Exercise


def split_exercises(exercises: Iterable[Exercise]) -> tuple[list[Exercise], list[Exercise]]:
    """Part the exercises of a chapter: its own, and the challenges; each keeps its order."""
    every = list(exercises)
    return (
        [one for one in every if not one.is_challenge],
        [one for one in every if one.is_challenge],
    )


def describe_points(exercise: Exercise) -> str:
    """Say what an exercise earns."""
    if exercise.is_challenge:
        return "challenge"
    return f"{exercise.points} points" if exercise.points else "exercise without points"


def get_label(name: str) -> str:
    """Return the label above the heading of an exercise."""
    return f"exercise-{name.replace('_', '-')}"


def make_link(exercise: Exercise) -> str:
    """Return a link to an exercise, from any page."""
    return f"{{ref}}`{exercise.name} <{get_label(exercise.name)}>`"


def describe_effort(exercise: Exercise) -> str:
    """Say how hard an exercise is and how long it takes."""
    level = rate_exercise(exercise)
    return f"{level.mark} {level.name}, about {level.minutes} minutes"


def make_facts(exercise: Exercise) -> str:
    """Write the line below a statement."""
    objectives = ", ".join(f"**{name}**" for name in exercise.objectives)
    points = describe_points(exercise).capitalize()
    return (
        f"*{points}, {describe_effort(exercise)}. Practices {objectives}; "
        f"taught in {{ref}}`{exercise.section}`.*"
    )


def make_card(exercises: list[Exercise], chapter: Chapter) -> str:
    """Write the table at the top of an exercise page: what is required, what is not."""
    own, challenges = split_exercises(exercises)
    rows = ["| | |", "|---|---|", f"| Needed before | [{chapter.name}](../{chapter.page}.md) |"]
    if own:
        rows += [f"| **{_name_own(chapter)}** | {_describe_own(own)} |", *map(_make_row, own)]
    else:
        rows.append(f"| **Required** | nothing: this {chapter.noun} has challenges only |")
    if challenges:
        rows.append(f"| **Challenges** | optional, {_add_minutes(challenges)} |")
        rows += map(_make_row, challenges)
    return "\n".join(rows) + "\n"


def make_groups(exercises: list[Exercise], chapter: Chapter) -> dict[str, str]:
    """Write the headings above the exercises, by the name of the first exercise below each."""
    own, challenges = split_exercises(exercises)
    groups = {}
    if own:
        name = _name_own(chapter)
        order = " Solve them in this order." if len(own) > 1 else ""
        groups[own[0].name] = (
            f"## {name}: {_add_points(own)}\n\n{_add_minutes(own).capitalize()}.{order}\n"
        )
    if challenges:
        groups[challenges[0].name] = (
            "## Challenges: optional, without points\n\n"
            f"{_add_minutes(challenges).capitalize()}. They ask for what the library does not "
            "have, and nothing later needs them.\n"
        )
    return groups


def make_chapter_part(exercises: list[Exercise], chapter: Chapter) -> str:
    """Write the sentences of a chapter that lead to its exercises."""
    own, challenges = split_exercises(exercises)
    links = ", ".join(_link_with_points(one) for one in own)
    due = f"write the functions of this {chapter.noun} yourself: {links}"
    whose = "" if own else f" of this {chapter.noun}"
    names = ", ".join(make_link(one) for one in challenges)
    more = f" The challenges{whose} ask for what the library does not have: {names}."
    return (
        f"On the [exercise page](../{chapter.exercises}.md) you "
        f"{due if own else 'go beyond the lab'}.{more if challenges else ''}\n"
    )


def _link_with_points(exercise: Exercise) -> str:
    return make_link(exercise) + (f" ({exercise.points} points)" if exercise.points else "")


def _name_own(chapter: Chapter) -> str:
    return "Exercises" if chapter.is_extension else "Required"


def _describe_own(own: list[Exercise]) -> str:
    return f"{_add_points(own)}, {_add_minutes(own)}"


def _add_points(own: list[Exercise]) -> str:
    points = sum(one.points for one in own)
    return f"{points} of the lab's 100 points" if points else "without points"


def _add_minutes(exercises: list[Exercise]) -> str:
    return f"about {sum(rate_exercise(one).minutes for one in exercises)} minutes"


def _make_row(exercise: Exercise) -> str:
    points = f"{exercise.points} points, " if exercise.points else ""
    return f"| {make_link(exercise)} | {points}{describe_effort(exercise)} |"
