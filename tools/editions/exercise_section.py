"""Write the section that the instructor edition has for one exercise.

Its reference, its completion, its mistakes with what is measured of them, and its cases.
"""

from __future__ import annotations

import inspect
import textwrap
from typing import TYPE_CHECKING, Any

import numpy as np

from labutils.checks.table import Raised
from tools.editions.card_code import find_called, is_answered_by_library
from tools.editions.mistakes import SEEDS, Measured, measure

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from solutions import Exercise


def make_exercise(exercise: Exercise) -> str:
    """Return the section of one exercise."""
    kind = f"A lab exercise of {exercise.points} points"
    if exercise.home.is_extension:
        kind = "An exercise of an extension, without points"
    if not is_answered_by_library(exercise):
        kind = "A challenge: the library does not answer it"
    measured = measure(exercise)
    return f"""## `{exercise.name}`: {exercise.title}

{kind}. It practices {", ".join(exercise.objectives)}. The check sends learners
back to {{ref}}`{exercise.section}`. Tolerance: {exercise.tolerance_reason}.

### Reference solution of `{exercise.name}`

:::{{admonition}} Show the code
:class: dropdown
```python
{get_source(exercise.reference)}
```
:::

{make_completion(exercise)}### Mistakes in `{exercise.name}`

{chr(10).join(make_mistake(exercise, one) for one in measured)}

{make_pairs(exercise)}

Hints a learner may ask for:

{chr(10).join(f"{number}. {text}" for number, text in enumerate(exercise.hints, 1))}

### Points of `{exercise.name}`

{make_cases(exercise)}"""


def make_completion(exercise: Exercise) -> str:
    """Return the whole twin that learners complete before the exercise, and its slips."""
    completion = exercise.completion
    if completion is None:
        return ""
    slips = "\n".join(f"- `{one.line}`: {one.text}" for one in completion.slips)
    return f"""### Completion before `{exercise.name}`

Learners get this twin without the lines marked `open`, and without points.

:::{{admonition}} Show the code
:class: dropdown
```python
{get_source(completion.twin)}
```
:::

What the check recognizes in these lines:

{slips}

"""


def get_source(function: Callable[..., Any]) -> str:
    """Return the code of a function and of the helpers in its card that it calls."""
    return "\n\n".join(
        textwrap.dedent(inspect.getsource(one)).rstrip()
        for one in find_called(function) or [function]
    )


def make_mistake(exercise: Exercise, one: Measured) -> str:
    """Return one mistake as an item of a definition list."""
    count = len(exercise.visible())
    if len(one.rival_cases) == count:
        rival = "No other mistake looks like it on any case."
    else:
        told = list_cases(one.rival_cases, count)
        rival = f"**Closest** is *{one.rival}*, told apart by {told}."
    hidden = f"{100 * one.kept:.0f} % of the hidden cases"
    if exercise.points:
        hidden += f", {one.kept * exercise.points:.1f} of {exercise.points} points"
    return f"""**{one.name}**
: *{one.text[0].upper()}{one.text[1:]}*
: **Seen by** the gate *{one.gate}*, wrong on {list_cases(one.cases, count)}. **Worst**: \
{one.residual}. {rival} **Keeps** {hidden}.
"""


def list_cases(numbers: Iterable[int], count: int) -> str:
    """Write numbers of cases: "every case", "case 2", "cases 1, 3"."""
    texts = [str(number) for number in numbers]
    if len(texts) == count:
        return f"{'every case' if count > 1 else 'the only case'}"
    return f"case{'s' if len(texts) > 1 else ''} {', '.join(texts)} of {count}"


def make_pairs(exercise: Exercise) -> str:
    """Say which pairs are recognized and which coincide."""
    pairs = len(exercise.get_combinations()) - len(exercise.misconceptions)
    lines = [f"Of two mistakes at once, {pairs} pairs are recognized."]
    if exercise.absorbed:
        lines += ["Not told apart, because nothing could:", ""]
        lines += [f"- {one.first} and {one.second}: {one.reason}" for one in exercise.absorbed]
    return "\n".join(lines)


def make_cases(exercise: Exercise) -> str:
    """Return the cases as tables: what is shown to everybody, what decides."""
    hidden = exercise.hidden(np.random.default_rng(SEEDS[0]))
    share = exercise.points / len(hidden)
    due = exercise.collect_due(hidden)
    rows = [
        f"| visible {number} | {case.label} | none |"
        for number, case in enumerate(exercise.visible(), 1)
    ]
    for number, (case, outcome) in enumerate(zip(hidden, due, strict=True), 1):
        note = f", raises {outcome.kind}" if isinstance(outcome, Raised) else ""
        points = f"{share:.2f}" if exercise.points else "none"
        rows.append(f"| hidden {number} | {case.label}{note} | {points} |")
    return "\n".join(["| Case | What it shows | Points |", "|---|---|---:|", *rows])
