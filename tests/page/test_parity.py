"""The page's MuJoCo computes what the real package computes: numbers, rays, verdicts.

The page has another version of the engine, built for WebAssembly. What it does differently stands
in ``ACCEPTED``, with the cause; everything else has to agree.
"""

from __future__ import annotations

import json
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from solutions import load_exercises
from tests.helpers.scripts import load_script
from tools.derive.page_mujoco import DERIVED

#: Both compute in float64, in another order of operations: a few units in the last place, which
#: 500 steps of a damped neck and 1000 of a tumbling box let grow to less than this.
ROUNDING = 1e-9
#: Of 307,200 pixels: where two geoms touch, or one ends, the last bit decides which is seen.
MOST_TIES = 20

#: What differs and why, by the end of the name.
ACCEPTED = {
    "MjModel.actuator_ctrlspec": "new in 4.0, and written otherwise before",
    "MjModel.eq_data": "a row has 12 numbers in 4.0, 11 in 3.14; the last is new",
    "equality.0.data": "as eq_data",
    "MjModel.paths": "the page reads files from memory, by their names alone",
    "MjModel.tex_pathadr": "as paths",
    "MjModel.mesh_polymap": "3.14 lists the faces of a hull in another order",
    "MjModel.mesh_polynormal": "as mesh_polymap",
    "MjModel.mesh_polyvert": "as mesh_polymap",
    "MjData.dof_island": "not computed without constraints; 4.0 says -1, 3.14 holds nothing",
    "MjData.tree_island": "as dof_island",
}
#: What a dense Jacobian leaves as the memory came, in the page and in the real package.
UNDEFINED = ("J_colind", "J_rowsuper", "J_rowadr", "J_rownnz")


@pytest.fixture(scope="module")
def parity() -> ModuleType:
    return load_script("tests/page/inside/parity.py")


@pytest.fixture(scope="module")
def pairs(
    parity: ModuleType, page_said: dict[str, Any], shared_folder: Path
) -> dict[str, tuple[np.ndarray, np.ndarray]]:
    """All numbers: of the real package and of the page."""
    assert not page_said["parity"]["save_parity"]["error"]
    derived = json.loads(DERIVED.read_text("utf-8"))
    names = {
        kind: [name for name, text in derived["structs"][kind].items() if _is_array(text)]
        for kind in ("MjModel", "MjData")
    }
    ours = parity.collect(names, derived["views"])
    theirs = np.load(shared_folder / "page-out" / "parity.npz")
    assert set(ours) == set(theirs.files)
    defined = [
        name for name in ours if not name.endswith(tuple(f".efc_{one}" for one in UNDEFINED))
    ]
    return {name: (ours[name], theirs[name]) for name in defined}


def _is_array(text: str) -> bool:
    sizes = text.split()[1:]
    return bool(sizes) and sizes != ["*"]


def _is_same(due: np.ndarray, came: np.ndarray) -> bool:
    if due.shape != came.shape or due.dtype.kind != came.dtype.kind:
        return False
    if due.dtype.kind not in "fiub":
        return bool((due == came).all())
    gap = np.abs(due.astype(float) - came.astype(float))
    scale = max(1.0, float(np.abs(due.astype(float)).max())) if due.size else 1.0
    is_of_one_size = due.dtype.itemsize == came.dtype.itemsize
    return is_of_one_size and bool((gap <= ROUNDING * scale).all())


def test_all_numbers_agree_but_those_that_are_accepted(
    pairs: dict[str, tuple[np.ndarray, np.ndarray]],
) -> None:
    different = [name for name, pair in pairs.items() if not _is_same(*pair)]
    unexpected = [name for name in different if not name.endswith(tuple(ACCEPTED))]
    assert not unexpected, unexpected
    assert len(pairs) > 2000


def test_every_accepted_difference_is_one(
    pairs: dict[str, tuple[np.ndarray, np.ndarray]],
) -> None:
    different = [name for name, pair in pairs.items() if not _is_same(*pair)]
    assert all(any(name.endswith(end) for name in different) for end in ACCEPTED)


@pytest.mark.parametrize("kind", ["pose.", "K.", "fov.", "track", "box.", "mju_"])
def test_the_numbers_of_a_lab_agree(
    pairs: dict[str, tuple[np.ndarray, np.ndarray]], kind: str
) -> None:
    found = {name: pair for name, pair in pairs.items() if name.startswith(kind)}
    assert found
    for name, (due, came) in found.items():
        np.testing.assert_allclose(came, due, rtol=0, atol=ROUNDING, err_msg=name)


@pytest.fixture(scope="module")
def rays(page_said: dict[str, Any], shared_folder: Path) -> dict[str, tuple[Any, Any]]:
    assert not page_said["rays"]["save_rays"]["error"]
    ours = load_script("tests/page/inside/rays.py").collect(640, 480)
    theirs = np.load(shared_folder / "page-out" / "rays.npz")
    assert set(ours) == set(theirs.files)
    return {name: (ours[name], theirs[name]) for name in ours}


@pytest.mark.parametrize("camera", ["head_camera", "overview"])
def test_pictures_are_the_same(rays: dict[str, tuple[Any, Any]], camera: str) -> None:
    due, came = rays[f"{camera}.depth"]
    np.testing.assert_allclose(came, due, rtol=1e-6, atol=0)  # float32
    for name, limit in (("rgb", 0), ("geoms", MOST_TIES), ("multi", MOST_TIES)):
        due, came = rays[f"{camera}.{name}"]
        assert np.count_nonzero(due != came) <= limit, name


@pytest.mark.parametrize(
    "shape", ["box", "sphere", "capsule", "cylinder", "ellipsoid", "mesh", "hfield"]
)
def test_rays_meet_every_shape_alike(rays: dict[str, tuple[Any, Any]], shape: str) -> None:
    for name in ("ids", "one_ids"):
        due, came = rays[f"{shape}.{name}"]
        assert (due >= 0).sum() > 20
        np.testing.assert_array_equal(came, due)
    for name in ("distances", "one_distances", "normals"):
        due, came = rays[f"{shape}.{name}"]
        np.testing.assert_allclose(came, due, rtol=0, atol=ROUNDING)


def test_one_ray_and_many_rays_agree(rays: dict[str, tuple[Any, Any]]) -> None:
    for name, (_, one) in rays.items():
        if "one_" in name:
            many = rays[name.replace("one_", "")][1][: len(one)]
            np.testing.assert_allclose(one, many, rtol=0, atol=ROUNDING)


@pytest.fixture(scope="module")
def verdicts(page_said: dict[str, Any]) -> dict[str, list[Any]]:
    assert not page_said["exercises"]["judge_all"]["error"]
    said: dict[str, list[Any]] = page_said["exercises"]["judge_all"]["value"]
    return said


def test_verdicts_are_those_of_the_real_package(verdicts: dict[str, list[Any]]) -> None:
    here = load_script("tests/page/inside/exercises.py").judge_all()
    assert verdicts == json.loads(json.dumps(here))
    assert len(verdicts) > 500


@pytest.mark.parametrize("name", load_exercises())
def test_an_exercise_is_judged_in_the_page(verdicts: dict[str, list[Any]], name: str) -> None:
    assert verdicts[f"{name}: reference"][0] == "passed"
    assert verdicts[f"{name}: starter"][0] == "failed"
    for mistake in load_exercises()[name].misconceptions:
        assert verdicts[f"{name}: {mistake.name}"][::2] == ["failed", mistake.name]
