"""Write down how the slow tests ended: a table that the book shows.

It holds no date and no duration, so that the same tests on the same versions give the same text.
"""

from __future__ import annotations

import platform
import re
from collections import Counter
from collections.abc import Iterable, Mapping
from importlib.metadata import version
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
TABLE = ROOT / "book" / "_generated" / "slow_tests.md"
MADE_BY = "<!-- Made by `make test-slow`. -->"
OUTCOMES = ("passed", "failed", "skipped")
PACKAGES = {
    "NumPy": "numpy",
    "OpenCV": "opencv-python-headless",
    "MuJoCo": "mujoco",
    "pytest": "pytest",
}
ROW = re.compile(r"^\| `(tests/\S+)` \| (\d+) \| (\d+) \| (\d+) \|$", re.MULTILINE)

#: Slow tests of a session by their file, the deselected ones too; and whether all were collected.
COLLECTED = pytest.StashKey[Counter[str]]()
COMPLETE = pytest.StashKey[bool]()


def collect_results(stats: Mapping[str, Iterable[pytest.TestReport]]) -> dict[str, Counter[str]]:
    """Count outcomes by file, from what a terminal reporter has counted."""
    found: dict[str, Counter[str]] = {}
    for name, outcome in [*zip(OUTCOMES, OUTCOMES, strict=True), ("error", "failed")]:
        for report in stats.get(name, ()):
            found.setdefault(report.nodeid.split("::")[0], Counter())[outcome] += 1
    return found


def collect_reasons(stats: Mapping[str, Iterable[pytest.TestReport]]) -> list[str]:
    """List the tests that failed, and why others were skipped."""
    broken = {one.nodeid for name in ("failed", "error") for one in stats.get(name, ())}
    skipped = {_get_reason(one) for one in stats.get("skipped", ())}
    return [f"failed: `{one}`" for one in sorted(broken)] + [
        f"skipped: {one}" for one in sorted(skipped)
    ]


def _get_reason(report: pytest.TestReport) -> str:
    assert isinstance(report.longrepr, tuple)  # file, line, reason
    return report.longrepr[2].removeprefix("Skipped: ")


def make_table(results: Mapping[str, Counter[str]], reasons: Iterable[str]) -> str:
    """Write the page's part: versions, counts by file, reasons."""
    versions = [f"{name} {version(package)}" for name, package in PACKAGES.items()]
    python = ".".join(platform.python_version_tuple()[:2])
    total = sum(results.values(), Counter[str]())
    rows = [
        f"| {name} | {' | '.join(str(counts[one]) for one in OUTCOMES)} |"
        for name, counts in [*((f"`{k}`", results[k]) for k in sorted(results)), ("all", total)]
    ]
    lines = [
        MADE_BY,
        "",
        f"Python {python}, {', '.join(versions)}:",
        "",
        "| slow tests | passed | failed | skipped |",
        "|---|---|---|---|",
        *rows,
        *(
            f"\n- {reason}" if not number else f"- {reason}"
            for number, reason in enumerate(reasons)
        ),
    ]
    return "\n".join(lines) + "\n"


def read_table(text: str) -> dict[str, Counter[str]]:
    """Read the counts of a table again."""
    return {
        name: Counter(dict(zip(OUTCOMES, map(int, counts), strict=True)))
        for name, *counts in ROW.findall(text)
    }
