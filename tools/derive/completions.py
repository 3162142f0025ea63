"""Write what learners get of a completion: its starter, its part of the exercise page, its words.

A completion stands before its exercise: a twin of which two lines are missing. It is derived from
the card of the exercise, see `solutions._completion`.
"""

from __future__ import annotations

import ast
from typing import TYPE_CHECKING, Any

from solutions._completion import find_open_lines, read_source
from tools.derive.starters import WIDTH

if TYPE_CHECKING:
    from labutils.checks.table import CheckTable
    from solutions import Exercise
    from solutions._completion import Completion


def make_starter(completion: Completion) -> str:
    """Return the imports and the twin, with ``...`` and a comment in place of its open lines."""
    lines = read_source(completion.twin)
    for open_line in find_open_lines(completion.twin):
        lines[open_line.number] = open_line.blank
    function = ast.parse("\n".join(lines)).body[0]
    assert isinstance(function, ast.FunctionDef)  # noqa: S101 - twins are plain functions
    body = lines[function.body[0].lineno - 1 :]
    for argument in function.args.args:
        argument.annotation = None  # the names in them are not imported where a learner writes
    head = f"def {completion.name}({ast.unparse(function.args)}):"
    top = [*completion.imports, "", ""] if completion.imports else []
    code = "\n".join([*top, head, *body])
    if too_long := [line for line in code.splitlines() if len(line) > WIDTH]:
        raise ValueError(f"{completion.name}: expected lines of at most {WIDTH}, got {too_long}")
    return f"{code}\n"


def get_label(completion: Completion) -> str:
    """Return the label above the heading of a completion."""
    return f"completion-{completion.name.replace('_', '-')}"


def make_part(exercise: Exercise, completion: Completion) -> str:
    """Write the section of an exercise page that comes before the exercise."""
    exercise_label = f"exercise-{exercise.name.replace('_', '-')}"
    return f"""\
({get_label(completion)})=
## Complete it first: {completion.title}

{completion.statement}

*No points. A twin of {{ref}}`{exercise.name} <{exercise_label}>`, with two lines missing. Worked \
example: {{ref}}`{completion.section}`*

```{{code-cell}} ipython3
:tags: [exercise, completion]
{make_starter(completion).strip()}
```

```{{code-cell}} ipython3
check("{completion.name}", {completion.name})
```
"""


def add_words(words: dict[str, Any], table: CheckTable) -> dict[str, Any]:
    """Add what only the table of a completion says."""
    return {**words, "open_lines": table.open_lines, "leads_to": table.leads_to}
