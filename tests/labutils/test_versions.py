"""An older MuJoCo is named at import, in one sentence, and geometry does without any."""

from __future__ import annotations

import subprocess
import sys
import tomllib
from pathlib import Path

import mujoco
import pytest

from labutils._versions import OLDEST_MUJOCO, check_mujoco_version, is_older

ROOT = Path(__file__).resolve().parents[2]

WORDS = (
    "labutils needs MuJoCo 4.0 or later, found {}: rays of older ones pass through parts of "
    'robots; to get it: pip install "mujoco>=4.0"'
)


@pytest.mark.parametrize("version", ["3.17.0", "3.9.0", "2.3.7", "3.14.1.dev2"])
def test_an_older_mujoco_is_refused_with_what_to_install(version: str) -> None:
    with pytest.raises(ImportError) as refused:
        check_mujoco_version(version)
    assert str(refused.value) == WORDS.format(version)


@pytest.mark.parametrize("version", ["4.0.0", "4.0.0rc1", "4.10.2", "10.0.0", mujoco.__version__])
def test_the_oldest_and_every_later_mujoco_is_accepted(version: str) -> None:
    check_mujoco_version(version)


def test_the_build_of_a_page_is_not_judged_by_its_version(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "platform", "emscripten")
    check_mujoco_version("3.14.0")


def test_versions_are_compared_as_numbers() -> None:
    assert is_older("0.9.1", (0, 20))
    assert not is_older("0.20.0+1e7b174", (0, 20))
    assert not is_older("1.0", (0, 20))
    assert not is_older("head", (0, 20))


def test_the_package_asks_for_the_same_version() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert f"mujoco>={'.'.join(map(str, OLDEST_MUJOCO))}" in project["dependencies"]


def test_an_older_mujoco_stops_the_scene_and_not_the_geometry() -> None:
    lines = [
        "import sys, types",
        "old = types.ModuleType('mujoco')",
        "old.__version__ = '3.17.0'",
        "sys.modules['mujoco'] = old",
        "import labutils",
        "print(labutils.intrinsics_matrix(1.0, 4, 3).shape)",
        "try:",
        "    labutils.make_scene()",
        "except ImportError as error:",
        "    print(error)",
    ]
    done = subprocess.run(
        [sys.executable, "-c", "\n".join(lines)],
        capture_output=True,
        text=True,
        check=False,
        timeout=60,
    )
    assert done.stdout.splitlines() == ["(3, 3)", WORDS.format("3.17.0")], done.stderr


def test_the_start_page_names_the_versions_that_the_package_asks_for() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    _, _, section = (ROOT / "book" / "start.md").read_text("utf-8").partition("(start-versions)=")
    section, _, _ = section.partition("\n## ")
    asked = {"Python": project["requires-python"].removeprefix(">=")}
    view = project["optional-dependencies"]["view"]
    for line in (*project["dependencies"], *view):
        name, _, version = line.partition(">=")
        asked[name] = version
    shown = {
        "Python": "Python",
        "mujoco": "MuJoCo",
        "numpy": "NumPy",
        "opencv-python-headless": "OpenCV",
        "open3d": "Open3D",
    }
    for name, words in shown.items():
        assert f"{words} {asked[name]}" in section, f"expected {words} {asked[name]}"
