"""Why a mutant may pass: by its name, or by the beginning of its name."""

from __future__ import annotations

_FEW = (
    "the hidden cases refuse it; among the visible ones it would need another picture of its own, "
    "with the answers of 28 mistakes and pairs of them"
)

#: Begin of a mutant's name to the reason; the longest that fits counts.
REASONS: dict[str, str] = {
    "labutils/_back_projection.py:_is_full:body.2.value.args.0.values.0:compare-Lt": _FEW,
    "labutils/_back_projection.py:_is_full:body.2.value.args.0.values.1:compare-Gt": _FEW,
    "labutils/_guards.py:check_pose:body.7.test.values.1.comparators.0:plus-1": (
        "refuses rotations whose determinant is rounded to less than 1: a matter of chance, so the "
        "poses of a few seeds are none of them"
    ),
    "labutils/stereo_refining.py:lr_check:body.7.value.left.comparators.0:minus-1": (
        "asks the last column about a point one column outside, which contradicts nearly always"
    ),
    "labutils/stereo_refining.py:subpixel:body.6.body.2.value.keywords.0:keyword-lost": (
        "moves by what the memory held before, which is 0 as often as not: a matter of chance"
    ),
    "solutions/control.py:_locate_center:body.9.value.slice:compare-NotEq": (
        "takes the distance of the room for that of the ball: the direction stays right, and the "
        "statement asks for nothing else"
    ),
}


def get_reason(mutant: str) -> str:
    """Return why a mutant may pass, or ""."""
    fitting = [start for start in REASONS if mutant.startswith(start)]
    return REASONS[max(fitting, key=len)] if fitting else ""
