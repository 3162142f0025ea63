"""Collect this room in its own environment only; write its table down."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path

import pytest

from tests.foreign import report
from tests.foreign.views import VIEWS, View

HERE = Path(__file__).resolve().parent
IS_ENVIRONMENT = all(find_spec(name) for name in ("dm_control", "robosuite", "gymnasium"))

#: Largest distance of two points in millimeters, as the test of the clouds finds it; and drake's
#: version.
CLOUDS = pytest.StashKey[dict[View, float]]()
DRAKE = pytest.StashKey[str]()


def pytest_addoption(parser: pytest.Parser) -> None:
    """Let `make foreign` say where drake is, and where the table goes."""
    parser.addoption("--drake", metavar="PYTHON", help="the Python of the environment drake")
    parser.addoption("--record-foreign", metavar="FILE", help="write what was found")


def pytest_ignore_collect(collection_path: Path) -> bool | None:
    """Leave the room out where the peers are not installed."""
    left_out = not IS_ENVIRONMENT and collection_path.name.startswith("test_")
    return True if left_out else None


@pytest.fixture(autouse=True)
def elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Work in a folder of its own: MuJoCo writes MUJOCO_LOG.TXT where a model gives a warning."""
    monkeypatch.chdir(tmp_path)


def pytest_configure(config: pytest.Config) -> None:
    """Begin with nothing found; let the peers use what is going to change."""
    if not IS_ENVIRONMENT:
        asked = [Path(config.invocation_params.dir, one.split("::")[0]) for one in config.args]
        if any(path.resolve().is_relative_to(HERE) for path in asked):
            raise pytest.UsageError(
                "tests/foreign needs dm_control, robosuite and gymnasium: run `make foreign`, "
                "which makes an environment with them"
            )
        return  # the session of the other rooms
    config.stash[CLOUDS] = {}
    config.stash[DRAKE] = "not run"
    # What the peers and what they stand on are warned of is theirs. What rays pass through is
    # measured here.
    config.addinivalue_line("filterwarnings", "default::DeprecationWarning")
    config.addinivalue_line("filterwarnings", "ignore:the ray caster draws geoms only")


def pytest_terminal_summary(
    terminalreporter: pytest.TerminalReporter, config: pytest.Config
) -> None:
    """Write the table, if all of it was found."""
    path = config.getoption("--record-foreign", default=None)
    if path is None:
        return
    if terminalreporter.stats.get("failed") or terminalreporter.stats.get("error"):
        terminalreporter.write_line("foreign: no table is written, because not all is green")
        return
    from tests.foreign.measuring import measure  # noqa: PLC0415 - imports the peers

    table = report.make_table(
        [measure(view) for view in VIEWS], config.stash[CLOUDS], config.stash[DRAKE]
    )
    (config.rootpath / path).write_text(table, encoding="utf-8")
