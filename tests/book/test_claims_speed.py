"""Sentences of the page on speed, against the tables that the bench has written into it."""

from __future__ import annotations

import re

import pytest

from tools import ROOT

TABLE = ROOT / "book" / "_generated" / "bench.md"
ROW = re.compile(r"\| (.+?) \| ([\d.]+) \(([\d.]+)\) \| ([\d.]+) \(([\d.]+)\) \|")
Row = tuple[float, float, float, float]


@pytest.fixture(scope="module")
def rows() -> dict[str, Row]:
    """Median and fastest as installed, then tuned, by route: of the first table that has it."""
    found: dict[str, Row] = {}
    for name, *numbers in ROW.findall(TABLE.read_text(encoding="utf-8")):
        a, b, c, d = map(float, numbers)
        found.setdefault(name, (a, b, c, d))
    return found


def get_swing(row: Row) -> float:
    """Return the median over the fastest run, as installed."""
    return row[0] / row[1]


def get_gain(row: Row) -> float:
    """Return what a route gains where memory is kept, as a factor."""
    return row[0] / row[2]


def test_the_median_of_the_tensor_interface_swings(rows: dict[str, Row]) -> None:
    swings = {name: get_swing(row) for name, row in rows.items()}
    tensor = [value for name, value in swings.items() if "o3d.t" in name]
    others = [value for name, value in swings.items() if "o3d.t" not in name]
    assert min(tensor) > max(others)


def test_open3d_gains_most_from_keeping_memory(rows: dict[str, Row]) -> None:
    gains = {name: get_gain(row) for name, row in rows.items()}
    open3d = [value for name, value in gains.items() if "Open3D" in name]
    others = [value for name, value in gains.items() if "Open3D" not in name]
    assert min(open3d) > max(others)


def test_what_does_less_is_faster_than_the_cloud(rows: dict[str, Row]) -> None:
    by_less = [row for name, row in rows.items() if "no filter" in name or "no cloud" in name]
    assert len(by_less) == 2
    assert all(max(row) < 1 for row in by_less)


def test_a_cloud_of_this_size_takes_7_to_14_megabytes() -> None:
    shown = re.search(r"([\d,]+) points", TABLE.read_text(encoding="utf-8"))
    assert shown is not None
    count = int(shown[1].replace(",", ""))
    # Three coordinates and three colors, of four bytes or of eight.
    assert [round(count * 6 * size / 1e6) for size in (4, 8)] == [7, 14]
