"""Tell a starter that nobody has touched from a function whose body somebody has written.

Answers alone cannot tell: a function that still raises at its end, or that forgot its `return`,
answers like the starter.
"""

from __future__ import annotations

import dis
import inspect
import itertools
from types import CodeType, EllipsisType


def is_begun(function: object) -> bool:
    """Tell whether the body of a function has more in it than a starter has.

    Parameters
    ----------
    function : object
        The learner's; None where only its answers are known.

    Returns
    -------
    bool
        False for a body of a docstring, `pass`, `...` and `raise NotImplementedError`; also where
        there is no function to look at.

    Examples
    --------
    >>> is_begun(lambda depth: None)
    False
    >>> is_begun(lambda depth: print(depth))
    True
    """
    if function is None:
        return False
    code = getattr(inspect.unwrap(function), "__code__", None)  # type: ignore[arg-type]
    if not isinstance(code, CodeType):
        return True  # an object that somebody has made callable
    arguments = code.co_argcount + code.co_kwonlyargcount
    arguments += bool(code.co_flags & inspect.CO_VARARGS) + bool(
        code.co_flags & inspect.CO_VARKEYWORDS
    )
    has_names = bool(set(code.co_names) - {"NotImplementedError"})
    has_variables = len(code.co_varnames) > arguments or bool(code.co_cellvars)
    return has_names or has_variables or _has_values(code) or _uses_arguments(code)


def count_open_lines(function: object) -> int:
    """Count the values of a starter that are still ``...``.

    Parameters
    ----------
    function : object
        The learner's.

    Returns
    -------
    int
        How often ``...`` is assigned; a ``...`` inside of an index is none.

    Examples
    --------
    >>> def halve(picture):
    ...     half = ...
    ...     return half[..., ::2]
    >>> count_open_lines(halve)
    1
    """
    code = getattr(inspect.unwrap(function), "__code__", None)  # type: ignore[arg-type]
    if not isinstance(code, CodeType):
        return 0
    steps = [one for one in dis.get_instructions(code) if one.opname != "CACHE"]
    return sum(
        step.argval is Ellipsis and following.opname.startswith(("STORE_", "UNPACK_"))
        for step, following in itertools.pairwise(steps)
    )


def _has_values(code: CodeType) -> bool:
    """Tell whether it holds a number or the like; texts are docstrings and messages."""
    nothing = (str, EllipsisType, type(None))
    return not all(isinstance(value, nothing) for value in code.co_consts)


def _uses_arguments(code: CodeType) -> bool:
    return any("_FAST" in step.opname for step in dis.get_instructions(code))
