"""Compare the speed of the library with that of others, and write the tables the book shows.

``make bench`` runs it. Every route first has to give the same points; then all of them take
turns, so that whatever else the machine does falls on all of them alike. The tables hold ratios,
because milliseconds are a property of the machine.
"""

from __future__ import annotations

import argparse
import statistics
import subprocess
import tempfile
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

import numpy as np

from labutils import (
    depth_to_pointcloud,
    get_camera_intrinsics,
    make_renderer,
    make_scene,
    render_camera,
)
from tools import ROOT
from tools.bench.workers import SETTINGS, Entry, Seconds, find_python, measure_group

TABLE = ROOT / "book" / "_generated" / "bench.md"
CAMERA, WIDTH, HEIGHT = "head_camera", 640, 480

WORLD_ROUTES = "tools.bench.world_routes"
ONE_THREAD = {"OPENBLAS_NUM_THREADS": "1"}  # what NumPy multiplies matrices with

# The first entry of each group is what the others are compared with.
CLOUD = {
    "labutils": Entry("`labutils.depth_to_pointcloud`"),
    "open3d_legacy": Entry("Open3D, `o3d.geometry`"),
    "open3d_legacy_prebuilt": Entry("Open3D, `o3d.geometry`, its images made beforehand"),
    "open3d_tensor": Entry("Open3D, `o3d.t.geometry`", ordered=False),
    "open3d_tensor_prebuilt": Entry(
        "Open3D, `o3d.t.geometry`, its images made beforehand", ordered=False
    ),
    "textbook": Entry("the lab sheet's way, plain NumPy"),
    "opencv": Entry("`cv2.depthTo3d`: no colors, no filter", comparable=False),
    "copy": Entry("copying the two pictures: no cloud at all", comparable=False),
}
WORLD = {
    "cloud_labutils": Entry("`depth_to_pointcloud` and `camera_to_world`", WORLD_ROUTES),
    "drake": Entry(
        "drake, `DepthImageToPointCloud`; sky taken out by NumPy, colors left as bytes",
        "tools.bench.drake_route",
        environment="drake",
    ),
    "drake_prebuilt": Entry(
        "the same, its images made beforehand, sky left in",
        "tools.bench.drake_route",
        environment="drake",
        comparable=False,
    ),
    "cloud_open3d": Entry("Open3D, `o3d.geometry`", WORLD_ROUTES),
    "cloud_open3d_prebuilt": Entry(
        "Open3D, `o3d.geometry`, its images made beforehand", WORLD_ROUTES
    ),
    "cloud_numpy": Entry("`depth_to_pointcloud` and NumPy's `@`", WORLD_ROUTES),
}
TURN = {
    "turn_opencv": Entry("`cv2.transform`", WORLD_ROUTES),
    "turn_labutils": Entry("`labutils.camera_to_world`", WORLD_ROUTES),
    "turn_numpy": Entry("NumPy, `points @ R.T + t`", WORLD_ROUTES),
    "turn_numpy_one_thread": Entry("the same, with one thread", WORLD_ROUTES, variables=ONE_THREAD),
    "turn_numpy_product": Entry(
        "its product alone, with one thread", WORLD_ROUTES, comparable=False, variables=ONE_THREAD
    ),
    "turn_numpy_sum": Entry("its sum alone", WORLD_ROUTES, comparable=False),
}
RENDER = {
    "bare": Entry("two bare passes of `mujoco.Renderer`"),
    "render_camera": Entry("`labutils.render_camera`"),
    "color": Entry("the bare color pass alone", comparable=False),
    "color_no_shadow": Entry("the bare color pass alone, without shadows", comparable=False),
}

PACKAGES = {
    "MuJoCo": ("mujoco",),
    "NumPy": ("numpy",),
    "OpenCV": ("opencv-python-headless",),
    "Open3D": ("open3d-cpu", "open3d"),  # the small build on Linux, the only one elsewhere
}

# A turn is a burst, as in a camera loop; its first run only wakes the process and fills
# the caches. A rendering takes a hundred times as long, and no caches outlive it.
CLOUD_BURST, RENDER_BURST = 20, 1

#: What was measured: seconds of every route, by column of its table.
Columns = dict[str, Seconds]


def main() -> int:
    """Measure, print the tables and write them."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=40, help="turns per route, at least 40")
    parser.add_argument("--out", type=Path, default=TABLE, help="file to write")
    options = parser.parse_args()
    if options.rounds < 40:
        parser.error("--rounds: expected at least 40, for a median that stays")
    with tempfile.TemporaryDirectory() as folder:
        frames = save_frames(Path(folder))
        with np.load(frames["float32"]) as file:
            count = len(file["points"])

        def measure(group: dict[str, Entry], precision: str, setting: str, burst: int) -> Seconds:
            variables = SETTINGS[setting]
            return measure_group(group, frames[precision], variables, options.rounds, burst)

        found = {
            name: {setting: measure(group, "float32", setting, CLOUD_BURST) for setting in SETTINGS}
            for name, group in (("cloud", CLOUD), ("world", WORLD))
        }
        found["turn"] = {
            precision: measure(TURN, precision, "as installed", CLOUD_BURST) for precision in frames
        }
        found["render"] = {"time": measure(RENDER, "float32", "as installed", RENDER_BURST)}
    text = write_page(found, count)
    options.out.parent.mkdir(parents=True, exist_ok=True)
    options.out.write_text(text, encoding="utf-8")
    print_milliseconds(found)
    print(text)
    return 0


def save_frames(folder: Path) -> dict[str, Path]:
    """Render the real head camera once; every route gets this frame.

    The two frames, by name, differ in the precision of the points that are to be turned.
    """
    model, data = make_scene()
    with make_renderer(model, HEIGHT, WIDTH) as renderer:
        rgb, depth = render_camera(model, data, renderer, CAMERA)
    K, _ = get_camera_intrinsics(model, CAMERA, WIDTH, HEIGHT)
    points, _ = depth_to_pointcloud(depth, K)
    camera = data.camera(CAMERA)
    paths = {}
    for precision in ("float32", "float64"):
        paths[precision] = folder / f"{precision}.npz"
        np.savez(
            paths[precision],
            rgb=rgb,
            depth=depth,
            K=K,
            xpos=camera.xpos,
            xmat=camera.xmat,
            points=points.astype(precision),
        )
    return paths


def write_page(found: dict[str, Columns], count: int) -> str:
    """Write all comparisons as MyST tables of ratios."""
    versions = {name: find_version(names) for name, names in PACKAGES.items()}
    if python := find_python("drake"):
        versions["drake"] = ask_version(python, "drake")
    size = f"at {WIDTH}x{HEIGHT}: times"
    tables = (
        make_table(f"From RGB-D to a colored cloud {size} labutils", CLOUD, found["cloud"]),
        make_table(
            f"From RGB-D to a colored cloud in the world {size} labutils", WORLD, found["world"]
        ),
        make_table(
            f"{count:,} points from the camera into the world: times OpenCV", TURN, found["turn"]
        ),
        make_table(f"RGB and depth of one frame {size} the bare passes", RENDER, found["render"]),
    )
    measured = ", ".join(f"{name} {number}" for name, number in versions.items())
    return "\n".join(
        (
            "% written by tools/bench/clouds.py (make bench); do not edit",
            "",
            *tables,
            f"Ratios of medians; in brackets, of the fastest runs. Measured with {measured}.",
            "",
        )
    )


def make_table(title: str, entries: dict[str, Entry], columns: Columns) -> str:
    """Write one comparison with the first entry; what was not measured says so."""
    lines = [
        f":::{{table}} {title}",
        f"| route | {' | '.join(columns)} |",
        f"|---|{'---:|' * len(columns)}",
    ]
    first = next(iter(entries))
    for route, entry in entries.items():
        cells = [
            format_ratio(times[route], times[first]) if route in times else "not measured"
            for times in columns.values()
        ]
        lines.append(f"| {entry.label} | {' | '.join(cells)} |")
    return "\n".join((*lines, ":::", ""))


def find_version(packages: tuple[str, ...]) -> str:
    """Return the version of the first package that is installed."""
    for package in packages:
        try:
            return version(package)
        except PackageNotFoundError:
            continue
    raise SystemExit(f"bench: expected one of {', '.join(packages)} to be installed")


def ask_version(python: str, package: str) -> str:
    """Return the version of a package of another Python."""
    code = f"from importlib.metadata import version; print(version({package!r}))"
    done = subprocess.run([python, "-c", code], capture_output=True, text=True, check=True)
    return done.stdout.strip()


def format_ratio(times: list[float], reference: list[float]) -> str:
    """Return the ratio of the medians and, in brackets, of the fastest runs."""
    median = statistics.median(times) / statistics.median(reference)
    fastest = min(times) / min(reference)
    return f"{_round(median)} ({_round(fastest)})"


def _round(ratio: float) -> str:
    return f"{ratio:.1f}" if ratio > 2 else f"{ratio:.2f}"


def print_milliseconds(found: dict[str, Columns]) -> None:
    """Print what this machine took: not for the page, where it would be no one's number."""
    print(f"{'milliseconds':44} {'median':>8} {'fastest':>8}")
    for group in found.values():
        for column, seconds in group.items():
            for route, times in seconds.items():
                median, fastest = 1000 * statistics.median(times), 1000 * min(times)
                print(f"{column + ': ' + route:44} {median:8.3f} {fastest:8.3f}")
    print()


if __name__ == "__main__":
    raise SystemExit(main())
