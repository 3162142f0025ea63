"""One useful sentence about an exception: what it means, and what was special where it came up.

Everything said was seen: in the exception, in the line, in the values of its names, in the case.
Where nothing certain can be said there is no sentence.
"""

from __future__ import annotations

from labutils.checks.exceptions import (
    attributes,
    indices,
    names,
    opencv,
    operands,
    shapes,
    truths,
    values,
)
from labutils.checks.exceptions.site import Call, Site, find_site
from labutils.checks.exceptions.syntax import explain_syntax

__all__ = ["MAX_LENGTH", "Call", "explain"]

#: Two lines of a verdict.
MAX_LENGTH = 189

_RULES = (
    *names.RULES,
    *attributes.RULES,
    *operands.RULES,
    *indices.RULES,
    *shapes.RULES,
    *truths.RULES,
    *values.RULES,
    *opencv.RULES,
)


def explain(error: BaseException, filename: str, call: Call | None = None) -> str:
    """Explain an exception that a learner's code raised.

    Parameters
    ----------
    error : BaseException
        The exception, with its traceback.
    filename : str
        The file or cell of the learner's code, as code objects name it.
    call : Call, optional
        What a check called; without it a cell itself stopped.

    Returns
    -------
    str
        One or two short sentences, at most `MAX_LENGTH` characters; empty for unknown exceptions.
    """
    try:
        if isinstance(error, SyntaxError):
            return _shorten(explain_syntax(error)) if error.filename == filename else ""
        return _shorten(_explain(find_site(error, filename, call or Call())))
    except Exception:  # noqa: BLE001 - advice is an extra: the exception itself is told anyway
        return ""


def _explain(site: Site) -> str:
    text = str(site.error).strip()
    # Who raises an exception knows what its text means.
    rules = values.OWN_RULES if site.is_raised_here else _RULES
    return next(filter(None, (rule.explain(site, text) for rule in rules)), "")


def _shorten(text: str) -> str:
    """Leave out sentences at the end until the text is short enough."""
    while len(text) > MAX_LENGTH:
        text = text[: text.rfind(". ") + 1]
    return text
