"""Run the library's tests with the versions it supports, and write down how they ended.

Every environment whose name begins with ``matrix-`` is a row of the table that the book shows.
The table holds no date and no duration, so that the same tests on the same versions give the same
text. It is written only when all environments could be made and all tests ran to their end.

Usage: ``python -m tools.environments.matrix``; with names of rows, such as ``oldest``, it tests
those and writes nothing.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
from collections import Counter
from dataclasses import dataclass
from typing import TYPE_CHECKING
from xml.etree import ElementTree as ET  # what is read was written by our own pytest

from tools import ROOT
from tools.environments import (
    MADE,
    ROOM,
    NoEnvironmentError,
    list_environments,
    make_environment,
    read_python,
)

if TYPE_CHECKING:
    from pathlib import Path

TABLE = ROOT / "book" / "_generated" / "matrix.md"
LOCK = ROOT / "requirements.txt"
MADE_BY = "<!-- Made by `make matrix`. -->"
PREFIX = "matrix-"
#: What stands on the library alone: no page has to be built, no browser found.
TESTS = ("tests/labutils", "tests/checks", "tests/explorers", "tests/solutions", "tests/content")
#: Column of the table to the packages that may fill it.
PACKAGES = {
    "NumPy": ("numpy",),
    "OpenCV": ("opencv-python-headless",),
    "MuJoCo": ("mujoco",),
    "Open3D": ("open3d-cpu", "open3d"),
}
#: More than ten times what an environment takes on two busy cores.
TIMEOUT_S = 3600

_PIN = re.compile(r"^([\w.-]+)==([\w.+]+)", re.MULTILINE)
_ROW = re.compile(r"^\| `(\S+)` \|(.*)\|$", re.MULTILINE)


class MatrixError(RuntimeError):
    """The tests did not run to their end; the message says in which environment, and why."""


@dataclass(frozen=True)
class Outcome:
    """How the tests of one environment ended."""

    passed: int
    skipped: Counter[str]  # reason to number
    failed: tuple[str, ...]


def list_rows() -> list[str]:
    """Name the rows of the table, the oldest versions first."""
    names = [one.removeprefix(PREFIX) for one in list_environments() if one.startswith(PREFIX)]
    return sorted(names, key=lambda name: (name != "oldest", name))


def read_versions(lock: Path) -> dict[str, str]:
    """Read what a lock holds of every column; "-" where it holds none."""
    pins = _PIN.findall(lock.read_text(encoding="utf-8"))
    found = {}
    for column, packages in PACKAGES.items():
        # one lock may hold two versions, for an older and a newer Python
        versions = dict.fromkeys(version for name, version in pins if name in packages)
        found[column] = " or ".join(versions) or "-"
    return found


def read_outcome(report: Path) -> Outcome:
    """Count what a JUnit report of pytest holds."""
    passed, skipped, failed = 0, Counter[str](), []
    for case in ET.parse(report).getroot().iter("testcase"):  # noqa: S314 - see the import
        skip = case.find("skipped")
        if case.find("failure") is not None or case.find("error") is not None:
            failed.append(f"{case.get('classname')}::{case.get('name')}")
        elif skip is not None:
            skipped[skip.get("message", "").removeprefix("Skipped: ")] += 1
        else:
            passed += 1
    return Outcome(passed, skipped, tuple(sorted(set(failed))))


def run_tests(row: str, python: Path) -> Outcome:
    """Run the tests with the interpreter of an environment.

    Raises
    ------
    MatrixError
        If they took too long, or pytest itself ended otherwise than with a result.
    """
    report = MADE / f"{PREFIX}{row}.xml"
    report.unlink(missing_ok=True)
    options = ("-q", "-m", "not slow", "-n", "auto", "--dist", "worksteal")
    command = [str(python), "-m", "pytest", *TESTS, *options, f"--junitxml={report}"]
    # The library lies beside the tests; an environment holds only what it stands on.
    variables = {**os.environ, "PYTHONPATH": str(ROOT)}
    try:
        done = subprocess.run(
            [*command, "-p", "no:cacheprovider"],
            cwd=ROOT,
            env=variables,
            capture_output=True,
            text=True,
            check=False,
            timeout=TIMEOUT_S,
        )
    except subprocess.TimeoutExpired as error:
        raise MatrixError(f"{row}: the tests took longer than {TIMEOUT_S} s") from error
    if done.returncode not in (0, 1) or not report.is_file():
        last = "\n".join((done.stdout + done.stderr).strip().splitlines()[-10:])
        raise MatrixError(f"{row}: pytest ended with code {done.returncode}:\n{last}")
    return read_outcome(report)


def make_table(outcomes: dict[str, Outcome]) -> str:
    """Write the page's part: versions and counts by environment, reasons, the book's own lock."""
    head = ("environment", "Python", *PACKAGES, "passed", "skipped", "failed")
    rows = [head, ("---",) * len(head)]
    notes: dict[str, list[str]] = {}  # what happened to where
    for row, outcome in outcomes.items():
        counts = (outcome.passed, outcome.skipped.total(), len(outcome.failed))
        rows.append((f"`{row}`", *describe_row(row), *map(str, counts)))
        told = [f"failed: `{one}`" for one in outcome.failed]
        told += [f"{number} skipped: {why}" for why, number in sorted(outcome.skipped.items())]
        for one in told:
            notes.setdefault(one, []).append(f"`{row}`")
    versions = [f"{column} {version}" for column, version in read_versions(LOCK).items()]
    lines = [MADE_BY, "", *(f"| {' | '.join(cells)} |" for cells in rows), ""]
    lines += [*(f"- {', '.join(where)}, {one}" for one, where in notes.items()), ""]
    lines += [
        "Tests: " + ", ".join(f"`{one}`" for one in TESTS) + ", without the slow ones.",
        f"The book itself is built and tested with {', '.join(versions)}.",
    ]
    return "\n".join(lines) + "\n"


def describe_row(row: str) -> tuple[str, ...]:
    """Return the versions of an environment: its Python, and every package of the table."""
    name = f"{PREFIX}{row}"
    return (read_python(name), *read_versions(ROOM / f"{name}.txt").values())


def read_table(text: str) -> dict[str, tuple[str, ...]]:
    """Read the cells of a table again, by environment."""
    return {
        name: tuple(cell.strip() for cell in cells.split("|")) for name, cells in _ROW.findall(text)
    }


def make_rows(rows: list[str]) -> dict[str, Path]:
    """Make the environments of all rows and return their interpreters.

    Raises
    ------
    MatrixError
        If there is no such row, or some cannot be made; all of those are named.
    """
    if unknown := sorted(set(rows) - set(list_rows())):
        raise MatrixError(f"expected some of {', '.join(list_rows())}, got {', '.join(unknown)}")
    made, missing = {}, []
    for row in rows:
        name = f"{PREFIX}{row}"
        try:
            made[row] = make_environment(name)
        except NoEnvironmentError as error:
            missing.append(f"{row} (Python {read_python(name)}) cannot be made: {error}")
    if missing:
        raise MatrixError("\n".join(missing))
    return made


def main(arguments: list[str]) -> int:
    """Test and write the table; return a shell's exit code."""
    rows = arguments or list_rows()
    outcomes = {}
    try:
        for row, python in make_rows(rows).items():
            outcome = outcomes[row] = run_tests(row, python)
            counts = f"{outcome.passed} passed, {outcome.skipped.total()} skipped"
            print(f"matrix: {row}: {counts}, {len(outcome.failed)} failed", flush=True)
    except MatrixError as error:
        print(f"matrix: {error}", file=sys.stderr)
        print(f"matrix: {TABLE.name} stays as it was", file=sys.stderr)
        return 1
    failed = [f"{row}: {one}" for row, outcome in outcomes.items() for one in outcome.failed]
    for line in failed:
        print(f"matrix: failed: {line}", file=sys.stderr)
    if not arguments:
        TABLE.write_text(make_table(outcomes), encoding="utf-8")
        print(f"matrix: wrote {TABLE.name}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
