"""Write down what was found: a table for each peer, which the book shows.

It holds no date and no duration: the same versions on the same machine give the same text.
"""

from __future__ import annotations

import platform
import re
from collections.abc import Iterable, Sequence
from importlib.metadata import version
from typing import TYPE_CHECKING

from tests.foreign.views import HEIGHT, WIDTH, View

if TYPE_CHECKING:
    from tests.foreign.measuring import Found

MADE_BY = "<!-- Made by `make foreign`. -->"
PEERS = {"dm_control": "dm-control", "robosuite": "robosuite", "gymnasium": "gymnasium"}
PACKAGES = {**PEERS, "MuJoCo": "mujoco", "NumPy": "numpy"}
HEAD = (
    "model, camera",
    "kind",
    "pixels off",
    "our depth, mm",
    "its depth, mm",
    "one sample, mm",
    "unseen, %",
    "its K, mm",
)
CAPTION = re.compile(r"^:::\{table\} (\w+): \d+ cameras$", re.MULTILINE)
ROW = re.compile(r"^\| `(\S+)` `(\S+)` \| \w+ \| (\d+) \|", re.MULTILINE)


def make_table(found: Sequence[Found], clouds: dict[View, float], drake: str) -> str:
    """Write versions, one row for each camera, and the clouds compared with drake's.

    Parameters
    ----------
    found : sequence of Found
        In the order of the rows.
    clouds : dict of View to float
        Largest distance between our points in the world and drake's, in millimeters.
    drake : str
        Its version.
    """
    versions = ", ".join(f"{name} {version(package)}" for name, package in PACKAGES.items())
    python = ".".join(platform.python_version_tuple()[:2])
    same = sum(one.depth_mm == one.depth_single_mm for one in found)
    lines = [
        MADE_BY,
        "",
        f"Python {python}, {versions}; drake {drake} for the clouds.",
        f"Two pictures of {WIDTH} x {HEIGHT} for each camera, drawn by Mesa: no graphics card was",
        f"tried. With one sample a pixel, our depth is the same in {same} of {len(found)} rows.",
    ]
    groups = {peer: [one for one in found if one.view.peer == peer] for peer in PEERS}
    lines += _make_summary(groups)
    for peer, rows in groups.items():
        lines += [
            "",
            f":::{{table}} {peer}: {len(rows)} cameras",
            f"| {' | '.join(HEAD)} |",
            f"|---|---|{'---:|' * (len(HEAD) - 2)}",
            *map(_make_row, rows),
            ":::",
        ]
    lines += [
        "",
        ":::{table} Clouds in the world, ours and drake's: the largest distance of two points",
        "| model, camera | distance, mm |",
        "|---|---:|",
        *(f"| {_name(view)} | {_round(distance)} |" for view, distance in clouds.items()),
        ":::",
    ]
    return "\n".join(lines) + "\n"


def _make_summary(groups: dict[str, list[Found]]) -> list[str]:
    """Write one column for each peer: smallest and largest of what its table has."""
    cells = {
        "cameras": [str(len(rows)) for rows in groups.values()],
        "pixels off": [str(sum(x.differing_pixels for x in g)) for g in groups.values()],
        "our depth, mm": [_range(x.depth_mm for x in g) for g in groups.values()],
        "its depth, mm": [_range(x.peer_mm for x in g) for g in groups.values()],
        "one sample, mm": [_range(x.peer_single_mm for x in g) for g in groups.values()],
        "cameras where ours is nearer": [
            str(sum(x.depth_mm < x.peer_mm for x in g)) for g in groups.values()
        ],
        "its K puts points sideways by, mm": [
            _range(x.K_offset_mm for x in g if x.K_offset_px is not None) for g in groups.values()
        ],
        "its sky, as a share of the far plane": [
            _range(x.sky for x in g if x.sky is not None) for g in groups.values()
        ],
    }
    return [
        "",
        ":::{table} All cameras in short: smallest to largest of the tables below",
        f"| | {' | '.join(groups)} |",
        f"|---|{'---:|' * len(groups)}",
        *(f"| {name} | {' | '.join(row)} |" for name, row in cells.items()),
        ":::",
    ]


def _range(values: Iterable[float]) -> str:
    kept = sorted(values)
    if not kept:
        return "none"
    low, high = _round(kept[0]), _round(kept[-1])
    return low if low == high else f"{low} to {high}"


def _make_row(one: Found) -> str:
    cells = (
        _name(one.view),
        one.kind,
        one.differing_pixels,
        _round(one.depth_mm),
        _round(one.peer_mm),
        _round(one.peer_single_mm),
        f"{100 * one.unseen:.1f}",
        _tell_offset(one),
    )
    return f"| {' | '.join(map(str, cells))} |"


def _tell_offset(one: Found) -> str:
    if one.K_offset_px is None:
        return "none"
    x, y = one.K_offset_px[:2, 2]
    return "same" if max(abs(x), abs(y)) < 1e-9 else f"{one.K_offset_mm:.1f}"


def _name(view: View) -> str:
    return f"`{view.model}` `{view.camera}`"


def _round(millimeters: float) -> str:
    """Give two digits of what matters, and none below a ten-thousandth of a millimeter."""
    if millimeters < 1e-9:  # roundings of double precision
        return "0"
    if millimeters < 1e-4:
        return "<0.0001"
    return f"{millimeters:.1g}" if millimeters < 1e-3 else f"{millimeters:.2g}"


def read_table(text: str) -> dict[View, int]:
    """Read again how many pixels differ at each camera."""
    _, *parts = CAPTION.split(text)
    return {
        View(peer, model, camera): int(count)
        for peer, part in zip(parts[::2], parts[1::2], strict=True)
        for model, camera, count in ROW.findall(part.partition(":::\n")[0])
    }
