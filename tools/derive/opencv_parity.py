"""Print the verdict of every reference, mistake, pair and starter, one per line.

Run with two versions of OpenCV and compare the output: it has to be the same. The version is named
on standard error. Needs NumPy, OpenCV, MuJoCo and, for the registry of chapters,
PyYAML; nothing else.

Usage: ``python -m tools.derive.opencv_parity``.
"""

from __future__ import annotations

import sys

import cv2

from labutils.checks import judge
from labutils.checks.table import load_table
from tools import ROOT


def main() -> int:
    """Print the verdicts; return a shell's exit code."""
    from solutions import load_exercises  # noqa: PLC0415 - imports MuJoCo

    print(f"OpenCV {cv2.__version__}", file=sys.stderr)
    for name, exercise in load_exercises().items():
        table = load_table(name)
        starter: dict[str, object] = {}
        source = (ROOT / "exercises" / "_generated" / f"{name}.py").read_text(encoding="utf-8")
        exec(compile(source, name, "exec"), starter)  # noqa: S102 - our own derived file
        functions = {
            "reference": exercise.reference,
            "starter": starter[name],
            **{" + ".join(made): exercise.make_wrong(made) for made in exercise.get_combinations()},
        }
        for label, function in functions.items():
            verdict = judge(table, function)
            print(f"{name}: {label}: {verdict.result}, {verdict.property}, {verdict.misconception}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
