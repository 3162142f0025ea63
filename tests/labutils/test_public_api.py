"""The front door of the library: complete, documented, light."""

from __future__ import annotations

import doctest
import importlib
import inspect
import pkgutil
import re
import subprocess
import sys
from pathlib import Path

import pytest

import labutils

ROOT = Path(labutils.__file__).parents[1]
MODULES = [m.name for m in pkgutil.iter_modules(labutils.__path__) if m.name != "__main__"]
FUNCTIONS = [n for n in labutils.__all__ if inspect.isfunction(getattr(labutils, n))]

#: Name and argument order as the lab sheet has them: readers' code relies on these.
SIGNATURES = {
    "render_camera": "model, data, renderer, camera_name",
    "intrinsics_matrix": "fov_y, width, height",
    "get_camera_intrinsics": "model, camera_name, width, height",
    "process_depth": "depth_raw, near, far",
    "visualize_depth": "depth_metric, max_depth",
    "segment_by_color": "rgb_image, target_hsv_range",
    "find_object_centroid": "mask",
    "depth_to_pointcloud": "depth_metric, K, rgb_image",
    "camera_to_world": "points, cam_xpos, cam_xmat",
    "visualize_pointcloud": "points, colors",
}


@pytest.mark.parametrize("name", labutils.__all__)
def test_every_public_name_exists(name: str) -> None:
    assert getattr(labutils, name) is not None


def test_an_unknown_name_is_refused_as_usual() -> None:
    with pytest.raises(AttributeError, match="module 'labutils' has no attribute 'rendr'"):
        _ = labutils.rendr


def test_dir_lists_the_public_names() -> None:
    assert dir(labutils) == sorted(labutils.__all__)


@pytest.mark.parametrize("name", SIGNATURES)
def test_lab_functions_keep_their_arguments(name: str) -> None:
    given = inspect.signature(getattr(labutils, name)).parameters.values()
    # By keyword only there may be more: no code that goes by the lab sheet meets it.
    by_place = [one.name for one in given if one.kind is not one.KEYWORD_ONLY]
    assert ", ".join(by_place) == SIGNATURES[name]
    assert all(one.default is not one.empty for one in given if one.kind is one.KEYWORD_ONLY)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_public_docstrings_name_every_parameter_and_what_is_returned(name: str) -> None:
    function = getattr(labutils, name)
    text = read_statement(name)
    for parameter in inspect.signature(function).parameters:
        assert parameter in text, f"{name}: parameter {parameter} is not described"
    assert "Returns\n---" in text or re.search(r"\breturns\b", text)


def read_statement(name: str) -> str:
    """Read a docstring, and those of the functions it points to for the rest of the statement."""
    text = inspect.getdoc(getattr(labutils, name))
    assert text is not None, name
    for owner in re.findall(r"\b[Aa]s in `(\w+)`", text):
        assert owner in labutils.__all__, f"{name}: points to {owner}, which nobody can find"
        if owner != name:
            text += read_statement(owner)
    return text


def test_a_docstring_that_points_nowhere_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    def save(thing: object) -> None:
        """Save; parameters as in `nothing`."""

    monkeypatch.setattr(labutils, "save_outputs", save)
    with pytest.raises(AssertionError, match="points to nothing, which nobody can find"):
        read_statement("save_outputs")


@pytest.mark.parametrize("module", MODULES)
def test_examples_in_docstrings_are_true(module: str) -> None:
    result = doctest.testmod(importlib.import_module(f"labutils.{module}"))
    assert result.failed == 0


def test_the_docstrings_have_examples_at_all() -> None:
    finder = doctest.DocTestFinder()
    modules = [importlib.import_module(f"labutils.{name}") for name in MODULES]
    assert sum(bool(t.examples) for m in modules for t in finder.find(m)) >= 3


@pytest.mark.parametrize("path", sorted(ROOT.glob("labutils/**/*.py")), ids=lambda p: p.name)
def test_modules_stay_small(path: Path) -> None:
    assert len(path.read_text(encoding="utf-8").splitlines()) <= 300


def test_importing_the_library_is_light_and_needs_no_mujoco() -> None:
    # The browser has NumPy and OpenCV, and nothing else.
    code = """
import sys
for name in ('mujoco', 'open3d', 'matplotlib', 'tqdm'):
    sys.modules[name] = None
import numpy as np
from labutils import depth_to_pointcloud, find_object_centroid, process_depth, segment_by_color
print(process_depth(np.array([0.0]), 1, 2)[0])
"""
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=False, timeout=60
    )
    assert done.stdout.strip() == "1.0", done.stderr
