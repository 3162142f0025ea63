"""Write the tables of the stereo chapter: what matching gets right over views, seeds and rooms.

The slow test ``tests/tools/test_stereo_table.py`` measures all of it again; with ``make test-slow``
it also writes the tables. They name the script that measured them and its checksum.

Usage: ``python -m tools.measure.stereo_table``.
"""

from __future__ import annotations

import hashlib
import json
import statistics
import sys
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING, Any

from labutils.recordings import NOISE
from labutils.room import make_room
from labutils.room.designs import DESIGNS
from labutils.room.recorder import VIEWS, hash_textures
from labutils.room.scene import BASELINE
from tools import ROOT
from tools.measure import stereo

if TYPE_CHECKING:
    from collections.abc import Iterable

    from labutils.stereo_truth import DisparityScore

TABLE = ROOT / "book" / "_generated" / "stereo_table.md"
NUMBERS = TABLE.with_suffix(".json")
SCRIPT = Path(stereo.__file__)
PACKAGES = {"MuJoCo": "mujoco", "NumPy": "numpy", "OpenCV": "opencv-python-headless"}

MADE_BY = "% written by tools/measure/stereo_table.py (make test-slow); do not edit"

#: A mean and a standard deviation over the seeds.
Spread = list[float]


def main() -> int:
    """Measure and write; return a shell's exit code."""
    write(measure())
    print(TABLE.read_text(encoding="utf-8"))
    return 0


def write(found: dict[str, Any]) -> None:
    """Write the numbers, and the page's tables of them."""
    NUMBERS.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")
    TABLE.write_text(make_page(found), encoding="utf-8")


def measure(seeds: Iterable[int] = stereo.SEEDS) -> dict[str, Any]:
    """Measure both rooms; return plain numbers, shares from 0 to 1 and meters."""
    seeds = tuple(seeds)
    return {
        "script": SCRIPT.relative_to(ROOT).as_posix(),
        "script_sha256": hash_script(),
        "textures_sha256": {name: hash_textures(make_room(name)[0]) for name in DESIGNS},
        "versions": {name: version(package) for name, package in PACKAGES.items()},
        "seeds": len(seeds),
        "views": len(VIEWS),
        "rooms": {name: _measure_room(name, seeds) for name in DESIGNS},
    }


def hash_script() -> str:
    """Name the script that measures: other code, other numbers."""
    return hashlib.sha256(SCRIPT.read_bytes()).hexdigest()


def _measure_room(name: str, seeds: tuple[int, ...]) -> dict[str, Any]:
    methods = {
        method: {
            "regions": {
                region: _spread_scores(by_seed) for region, by_seed in scores.regions.items()
            },
            "views": {view: spread(by_seed) for view, by_seed in scores.views.items()},
        }
        for method, scores in stereo.score_methods(stereo.render_views(name), seeds).items()
    }
    baselines = [
        {
            "baseline": row.baseline,
            "seen": row.seen,
            "not_correct": spread(row.not_correct),
            "rmse": spread(row.rmse),
            "theory": spread(row.theory),
        }
        for row in stereo.score_baselines(name, seeds=seeds)
    ]
    return {"methods": methods, "baselines": baselines}


def _spread_scores(by_seed: dict[int, DisparityScore]) -> dict[str, Spread]:
    names = ("density", "bad1", "bad2", "wrong", "not_correct", "sd")
    return {
        name: spread({seed: getattr(score, name) for seed, score in by_seed.items()})
        for name in names
    }


def spread(by_seed: dict[int, float]) -> Spread:
    """Return the mean over the seeds and their standard deviation, to six digits."""
    values = list(by_seed.values())
    deviation = statistics.stdev(values) if len(values) > 1 else 0.0
    return [float(f"{one:.6g}") for one in (statistics.fmean(values), deviation)]


def make_page(found: dict[str, Any]) -> str:
    """Write the tables as MyST."""
    rooms = found["rooms"]
    versions = ", ".join(f"{name} {number}" for name, number in found["versions"].items())
    how = (
        f"{found['views']} views of 640x480 pixels in each room, noise of {NOISE:g} gray levels; "
        f"mean and standard deviation over {found['seeds']} seeds of the noise. Measured by "
        f"`{found['script']}` (SHA-256 {found['script_sha256'][:12]}) with {versions}."
    )
    tables = [*_make_methods(rooms), *_make_regions(rooms), *_make_baselines(rooms)]
    return "\n".join([MADE_BY, "", *tables, how, ""])


def _make_methods(rooms: dict[str, Any]) -> list[str]:
    columns = (
        "method",
        "found",
        "of these off by > 1 px",
        "of these off by > 2 px",
        "missing or off by > 2 px",
        "from view to view",
        "in the held-out room",
    )
    rows = []
    for method, scores in rooms["room"]["methods"].items():
        own = scores["regions"][stereo.SEEN]
        other = rooms["held_out"]["methods"][method]["regions"][stereo.SEEN]
        views = [mean for mean, _ in scores["views"].values()]
        between = f"{100 * min(views):.1f} to {100 * max(views):.1f} %"
        cells = [_percent(own[name]) for name in ("density", "bad1", "bad2", "not_correct")]
        rows.append((method, *cells, between, _percent(other["not_correct"])))
    title = f"What both eyes see, baseline {BASELINE:.2f} m, {stereo.DISPARITIES} disparities"
    return _make_table(title, columns, rows)


def _make_regions(rooms: dict[str, Any]) -> list[str]:
    columns = ("region", "SSD, refined and checked", "held out", "SGBM", "held out")
    rows = []
    for region in rooms["room"]["methods"][stereo.SGBM]["regions"]:
        cells = []
        for method in (stereo.SSD, stereo.SGBM):
            for room in ("room", "held_out"):
                score = rooms[room]["methods"][method]["regions"][region]
                cells.append(f"{_percent(score['not_correct'])} ({100 * score['wrong'][0]:.1f} %)")
        rows.append((region, *cells))
    return _make_table("Missing or off by > 2 px (in brackets, only off), by region", columns, rows)


def _make_baselines(rooms: dict[str, Any]) -> list[str]:
    columns = (
        "baseline",
        "seen by both eyes",
        "missing or off by > 2 px",
        "depth error, RMS",
        "theory",
        "measured / theory",
        "held out",
    )
    rows = []
    for row, other in zip(rooms["room"]["baselines"], rooms["held_out"]["baselines"], strict=True):
        rows.append(
            (
                f"{row['baseline']:.2f} m",
                f"{100 * row['seen']:.1f} %",
                _percent(row["not_correct"]),
                _format(row["rmse"], 1000, 1, " mm"),
                f"{1000 * row['theory'][0]:.1f} mm",
                *(f"{one['rmse'][0] / one['theory'][0]:.2f}" for one in (row, other)),
            )
        )
    near, far = stereo.COMPARED
    return _make_table(f"SGBM with five baselines, depth from {near} to {far} m", columns, rows)


def _make_table(title: str, columns: tuple[str, ...], rows: list[tuple[str, ...]]) -> list[str]:
    """Write one table; the first column holds names, the others numbers."""
    lines = [f":::{{table}} {title}", _make_row(*columns), f"|---|{'---:|' * (len(columns) - 1)}"]
    return [*lines, *(_make_row(*row) for row in rows), ":::", ""]


def _make_row(*cells: str) -> str:
    return f"| {' | '.join(cells)} |"


def _percent(value: Spread) -> str:
    return _format(value, 100, 1, " %")


def _format(value: Spread, factor: float, digits: int, unit: str) -> str:
    mean, deviation = (factor * one for one in value)
    # A spread that rounds to nothing would read as if there was none.
    more = digits + 1 if round(deviation, digits) == 0 else digits
    return f"{mean:.{digits}f} ± {deviation:.{more}f}{unit}"


if __name__ == "__main__":
    sys.exit(main())
