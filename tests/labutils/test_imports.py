"""The modules of the library stand on each other in one direction, and geometry on NumPy alone."""

from __future__ import annotations

import ast
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

import labutils

#: What every module imports of the others, by name.
Imports = dict[str, set[str]]

#: Geometry: what a robot without a screen, a grader or a browser needs first.
ON_NUMPY_ALONE = (
    "cameras",
    "depth_values",
    "free_camera",
    "ply",
    "projection",
    "stereo",
    "stereo_refining",
)

#: What geometry itself stands on.
BELOW_GEOMETRY = ("_constants", "_files", "_guards", "_ply_parts")


def read_modules(package: Path) -> dict[str, ast.Module]:
    """Parse every module of a package, by its dotted name."""
    found = {}
    for path in sorted(package.rglob("*.py")):
        parts = path.relative_to(package.parent).with_suffix("").parts
        name = ".".join(parts[:-1] if parts[-1] == "__init__" else parts)
        found[name] = ast.parse(path.read_text(encoding="utf-8"))
    return found


def find_imports(modules: dict[str, ast.Module]) -> Imports:
    """List what every module imports of the others, wherever in it: types and functions too.

    Whoever imports a module of a package from outside imports the package as well. Of the package
    that a module lies in, only what it names itself counts: the package was there first.
    """
    found: Imports = {name: set() for name in modules}
    for name, tree in modules.items():
        for node in ast.walk(tree):
            for target in _find_targets(node, modules):
                parts = target.split(".")
                packages = {".".join(parts[:end]) for end in range(1, len(parts))}
                inside = {one for one in packages if f"{name}.".startswith(f"{one}.")}
                found[name] |= ({target} | packages - inside) - {name}
    return found


def _find_targets(node: ast.AST, modules: dict[str, ast.Module]) -> list[str]:
    if isinstance(node, ast.Import):
        return [one.name for one in node.names if one.name in modules]
    if not isinstance(node, ast.ImportFrom):
        return []
    assert node.level == 0, f"a relative import in line {node.lineno}: write the whole name"
    below = [f"{node.module}.{one.name}" for one in node.names]
    submodules = [one for one in below if one in modules]
    plain = [node.module] if node.module in modules and len(submodules) < len(below) else []
    return submodules + plain


def find_circle(imports: Imports) -> list[str]:
    """Return the names along a circle, the first again at the end; [] if there is none."""
    done: set[str] = set()

    def visit(name: str, above: list[str]) -> list[str]:
        if name in above:
            return [*above[above.index(name) :], name]
        if name in done:
            return []
        for other in sorted(imports[name]):
            if circle := visit(other, [*above, name]):
                return circle
        done.add(name)
        return []

    return next(filter(None, (visit(name, []) for name in sorted(imports))), [])


def find_all_below(imports: Imports, name: str) -> set[str]:
    """Return all modules that a module stands on, directly or not."""
    found: set[str] = set()
    left = [name]
    while left:
        new = imports[left.pop()] - found
        found |= new
        left += new
    return found


@pytest.fixture(scope="module")
def imports() -> Imports:
    return find_imports(read_modules(Path(labutils.__file__).parent))


@pytest.fixture
def import_scratch(tmp_path: Path) -> Callable[[dict[str, str]], Imports]:
    """Write the modules of a package `a`, by path to text, and list what they import."""

    def make(texts: dict[str, str]) -> Imports:
        for name, text in texts.items():
            path = tmp_path / "a" / f"{name}.py"
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        return find_imports(read_modules(tmp_path / "a"))

    return make


def test_no_module_of_the_library_stands_on_itself(imports: Imports) -> None:
    assert len(imports) > 30
    circle = find_circle(imports)
    assert not circle, f"modules that import each other: {' -> '.join(circle)}"


def test_no_module_of_the_library_imports_from_its_front_door(
    imports: Imports,
) -> None:
    assert [name for name, others in imports.items() if "labutils" in others] == []


def test_a_cloud_stands_on_no_renderer(imports: Imports) -> None:
    below = find_all_below(imports, "labutils.pointcloud")
    assert "labutils.projection" in below
    drawn = {"camera_utils", "raycast", "rendering", "_ray_casting", "scene"}
    assert not {one for one in below if one.split(".")[1] in drawn | {"renderers"}}


def test_geometry_stands_on_nothing_that_is_not_geometry(
    imports: Imports,
) -> None:
    below = {f"labutils.{name}" for name in (*ON_NUMPY_ALONE, *BELOW_GEOMETRY)}
    for name in ON_NUMPY_ALONE:
        assert find_all_below(imports, f"labutils.{name}") <= below


@pytest.mark.parametrize(
    "hidden",
    [
        "from a.one import two",
        "def f():\n    import a.one",
        "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from a import one",
        "def f():\n    from a import one, three",
    ],
)
def test_a_circle_is_found_and_named_wherever_the_import_stands(
    import_scratch: Callable[[dict[str, str]], Imports], hidden: str
) -> None:
    imports = import_scratch({"__init__": "", "one": "import a.two", "two": hidden})
    assert find_circle(imports) == ["a.one", "a.two", "a.one"]


def test_a_circle_through_a_package_is_found(
    import_scratch: Callable[[dict[str, str]], Imports],
) -> None:
    texts = {
        "__init__": "",
        "one": "from a.sub.deep import x",
        "sub/__init__": "from a.sub.other import y",
        "sub/deep": "",
        "sub/other": "from a.one import z",
    }
    imports = import_scratch(texts)
    assert find_circle(imports) == ["a.one", "a.sub", "a.sub.other", "a.one"]


def test_neighbors_in_a_package_make_no_circle_with_it(
    import_scratch: Callable[[dict[str, str]], Imports],
) -> None:
    imports = import_scratch(
        {"__init__": "from a.one import x", "one": "from a.two import x", "two": "import os"}
    )
    assert find_circle(imports) == []


def test_geometry_runs_where_only_numpy_exists() -> None:
    lines = [
        "import sys",
        "for name in ('cv2', 'mujoco', 'matplotlib', 'open3d', 'tqdm', 'anywidget'):",
        "    sys.modules[name] = None",
        *(f"import labutils.{name}" for name in ON_NUMPY_ALONE),
        "import numpy as np",
        "from labutils import camera_to_world, find_valid_depth, pixels_to_points",
        "from labutils.stereo import depth_to_disparity",
        "K = np.array([[250.0, 0, 320], [0, 250.0, 240], [0, 0, 1]])",
        "print(pixels_to_points([[320, 240]], [2.0], K)[0].tolist())",
        "print(depth_to_disparity(2.0, K, 0.1), find_valid_depth([2.0, 99.0]).tolist())",
        "print(camera_to_world([[1, 2, 3]], [10, 20, 30], np.eye(3)).tolist())",
    ]
    done = subprocess.run(
        [sys.executable, "-c", "\n".join(lines)],
        capture_output=True,
        text=True,
        check=False,
        timeout=60,
    )
    said = ["[0.0, 0.0, 2.0]", "12.5 [True, False]", "[[11.0, 18.0, 27.0]]"]
    assert done.stdout.splitlines() == said, done.stderr


def test_a_camera_is_read_by_attribute_from_whatever_has_them() -> None:
    """No MuJoCo: a model that was stored, or one that a browser holds."""
    import numpy as np  # noqa: PLC0415 - beside its only use

    from labutils.cameras import get_camera_intrinsics, get_camera_pose  # noqa: PLC0415

    class Camera:
        def __init__(self, number: int, name: str) -> None:
            self.id, self.name = number, name

    class Model:
        ncam = 1
        cam_projection = np.array([0])
        cam_sensorsize = np.zeros((1, 2))
        cam_fovy = np.array([90.0])

        def camera(self, key: int | str) -> Camera:
            return {0: Camera(0, "eye"), "eye": Camera(0, "eye")}[key]

    class Data:
        cam_xmat = np.eye(3).reshape(1, 9)
        cam_xpos = np.array([[1.0, 2.0, 3.0]])

    K, fov_y = get_camera_intrinsics(Model(), "eye", 640, 480)
    assert fov_y == pytest.approx(np.pi / 2)
    assert K[0, 0] == pytest.approx(240)
    assert get_camera_pose(Model(), Data(), "eye")[:3, 3].tolist() == [1, 2, 3]
    with pytest.raises(ValueError, match="camera_name: expected one of eye, got 'nose'"):
        get_camera_intrinsics(Model(), "nose", 640, 480)


def test_every_module_of_the_lab_sheet_still_has_its_functions() -> None:
    from labutils import (  # noqa: PLC0415 - read as a reader would write it
        camera_utils,
        color_segmentation,
        depth_processing,
        pointcloud,
    )

    for module, names in {
        camera_utils: "render_camera intrinsics_matrix get_camera_intrinsics get_camera_pose",
        depth_processing: "process_depth visualize_depth find_valid_depth get_clip_planes "
        "get_depth_limits metric_to_raw render_raw_depth",
        color_segmentation: "segment_by_color find_object_centroid visualize_detection",
        pointcloud: "depth_to_pointcloud camera_to_world visualize_pointcloud world_to_camera "
        "pixels_to_points points_to_pixels",
    }.items():
        for name in names.split():
            assert getattr(module, name) is getattr(labutils, name)
