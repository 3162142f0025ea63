"""Fixtures the tests share."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest

from labutils import make_scene  # isort: skip - chooses the OpenGL backend, so before MuJoCo

import mujoco
import numpy as np

from tests.helpers import slow_report
from tests.helpers.scenes import make_asymmetric_scene
from tools.scaffold.unfilled import find_unfilled


@pytest.fixture
def scene() -> tuple[mujoco.MjModel, mujoco.MjData]:
    """The book's scene, fresh."""
    return make_scene()


@pytest.fixture
def asymmetric() -> tuple[mujoco.MjModel, mujoco.MjData]:
    """A scene whose cameras have fx != fy and an off-center principal point."""
    return make_asymmetric_scene()


@pytest.fixture
def K() -> np.ndarray:
    """Intrinsics that no two axes share: swapping u and v, or x and y, must show."""
    return np.array([[210.0, 0, 33.25], [0, 180.0, 20.5], [0, 0, 1]])


def pytest_addoption(parser: pytest.Parser) -> None:
    """Let `make test-slow` say where its result is written down."""
    parser.addoption("--record-slow", metavar="FILE", help="write how the slow tests ended")


@pytest.hookimpl(tryfirst=True)  # before -m leaves any out
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Count the slow tests that there are, whether they run or not."""
    slow = [item.nodeid.split("::")[0] for item in items if item.get_closest_marker("slow")]
    config.stash[slow_report.COLLECTED] = Counter(slow)
    files = {item.path for item in items}
    here = Path(__file__).parent
    # `foreign` is collected in an environment of its own, by `make foreign`.
    every = {*here.rglob("test_*.py")} - {*(here / "foreign").iterdir()}
    config.stash[slow_report.COMPLETE] = every <= files


def pytest_terminal_summary(
    terminalreporter: pytest.TerminalReporter, config: pytest.Config
) -> None:
    """Say how many chapters ran as notebooks, beside how many tests; record the slow ones."""
    if path := config.getoption("--record-slow"):
        stats = terminalreporter.stats
        table = slow_report.make_table(
            slow_report.collect_results(stats), slow_report.collect_reasons(stats)
        )
        Path(path).write_text(table, encoding="utf-8")
    runs = [
        value
        for report in terminalreporter.stats.get("passed", [])
        for name, value in report.user_properties
        if name == "notebook"
    ]
    if runs:
        terminalreporter.section("notebooks")
        for run in sorted(runs):
            terminalreporter.write_line(run)
    if places := find_unfilled():
        terminalreporter.section("still to be filled")
        for place in places:
            terminalreporter.write_line(str(place))
    tests = len(terminalreporter.stats.get("passed", []))
    terminalreporter.write_line(f"{tests} tests passed, {len(runs)} of them ran a notebook")
