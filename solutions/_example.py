"""The example of an exercise: a few lines that call a learner's function and show what it answers.

It stands on the page above the starter, and runs below it: after the cells that set the page up,
and with the imports of the starter.
"""

from __future__ import annotations

import ast

#: An example is read at a glance, and fits a cell of a page.
MAX_LINES, MAX_COLUMNS = 6, 76
#: What shows something.
_SHOWS = {"show", "print"}


def verify_example(name: str, code: str) -> None:
    """Refuse an example that is no code, is too long, calls another function, or shows nothing.

    A function may also be handed to what calls it.
    """
    lines = [line for line in code.splitlines() if line]
    if not 1 <= len(lines) <= MAX_LINES:
        raise ValueError(f"{name}: expected an example of 1 to {MAX_LINES} lines, got {len(lines)}")
    if code != code.strip():
        raise ValueError(f"{name}: expected an example without spaces around, got {code[-20:]!r}")
    longest = max(map(len, lines))
    if longest > MAX_COLUMNS:
        raise ValueError(
            f"{name}: expected an example of at most {MAX_COLUMNS} columns, got {longest}"
        )
    try:
        tree = ast.parse(code)
    except SyntaxError as error:
        raise ValueError(f"{name}: expected an example in Python, got {error.msg}") from error
    calls = [node for node in ast.walk(tree) if isinstance(node, ast.Call)]
    called = {node.func.id for node in calls if isinstance(node.func, ast.Name)}
    # What acts in a loop is handed to the loop, which calls it.
    handed = {one.id for node in calls for one in node.args if isinstance(one, ast.Name)}
    if name not in called | handed:
        raise ValueError(f"{name}: expected an example that calls it, got {sorted(called)}")
    if not called & _SHOWS:
        raise ValueError(f"{name}: expected an example that shows or prints, got {sorted(called)}")
