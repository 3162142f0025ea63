"""What the book says about the slow tests is what `make test-slow` found."""

from __future__ import annotations

import re
from collections import Counter
from types import SimpleNamespace
from typing import Any

import pytest

from tests.helpers.slow_report import (
    COLLECTED,
    COMPLETE,
    MADE_BY,
    ROOT,
    TABLE,
    collect_reasons,
    collect_results,
    make_table,
    read_table,
)


def end(nodeid: str, why: tuple[str, int, str] | None = None) -> Any:
    # stands for a report of pytest
    return SimpleNamespace(nodeid=nodeid, longrepr=why)


STATS = {
    "passed": [end("tests/b/test_b.py::test_one"), end("tests/a/test_a.py::test_two[1]")],
    "failed": [end("tests/b/test_b.py::test_three")],
    "error": [end("tests/b/test_b.py::test_four")],
    "skipped": [end("tests/a/test_a.py::test_two[2]", ("a.py", 3, "Skipped: no network"))],
    "deselected": [end("tests/a/test_a.py::test_quick")],
}


def test_every_outcome_is_counted_by_file_and_read_back() -> None:
    results = collect_results(STATS)
    text = make_table(results, collect_reasons(STATS))
    assert text.startswith(MADE_BY)
    assert "| `tests/a/test_a.py` | 1 | 0 | 1 |" in text
    assert "| `tests/b/test_b.py` | 1 | 2 | 0 |" in text
    assert "| all | 2 | 2 | 1 |" in text
    assert read_table(text) == {
        "tests/a/test_a.py": Counter(passed=1, skipped=1),
        "tests/b/test_b.py": Counter(passed=1, failed=2),
    }


def test_what_failed_and_why_others_were_skipped_is_named() -> None:
    reasons = collect_reasons(STATS)
    assert reasons == [
        "failed: `tests/b/test_b.py::test_four`",
        "failed: `tests/b/test_b.py::test_three`",
        "skipped: no network",
    ]
    assert make_table(collect_results(STATS), reasons).endswith(
        "| 1 |\n\n" + "".join(f"- {one}\n" for one in reasons)
    )


def test_the_text_names_versions_and_no_date() -> None:
    text = make_table(collect_results(STATS), [])
    assert re.search(r"Python 3\.\d+, NumPy \d+\.\d+", text)
    assert not re.search(r"20\d\d-|\d\d:\d\d", text)


def test_the_book_shows_a_green_result_of_the_slow_tests_that_there_are(
    request: pytest.FixtureRequest,
) -> None:
    if not request.config.stash[COMPLETE]:
        pytest.skip("counts the slow tests of all files, but only some files were collected")
    shown = read_table(TABLE.read_text(encoding="utf-8"))
    assert {name: counts["failed"] for name, counts in shown.items() if counts["failed"]} == {}
    counted = {name: counts.total() for name, counts in shown.items()}
    assert counted == request.config.stash[COLLECTED], "run `make test-slow`"


def test_the_book_shows_the_table() -> None:
    page = (ROOT / "book" / "architecture.md").read_text(encoding="utf-8")
    assert f"```{{include}} {TABLE.relative_to(ROOT / 'book').as_posix()}\n```" in page
