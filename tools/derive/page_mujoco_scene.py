"""The scene of the book for the page's engine, whose parser is older than the scene's format."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import mujoco

if TYPE_CHECKING:
    from pathlib import Path

_REPLICATE = re.compile(r"<replicate[^>]*>(.*?)</replicate>", re.DOTALL)
_CASTSHADOW = re.compile(r"(<geom\b[^>]*?)\s+castshadow=\"\w+\"")


def make_page_scene(path: Path) -> str:
    """Return the text of a scene without what the page's engine reads otherwise or not at all.

    Geoms lose ``castshadow``, which no picture by rays shows. A ``replicate`` becomes its copies,
    at the full precision of the compiled scene: the older engine turns them by rounded angles.
    """
    model = mujoco.MjModel.from_xml_path(str(path))
    text = _REPLICATE.sub(lambda found: _expand(found[1], model), path.read_text(encoding="utf-8"))
    return _CASTSHADOW.sub(r"\1", text)


def _expand(inner: str, model: mujoco.MjModel) -> str:
    """Write the copies of a replicated geom one by one, as they were compiled."""
    prefix = _get_name(inner)
    names = (model.geom(number).name for number in range(model.ngeom))
    copies = [name for name in names if re.fullmatch(re.escape(prefix) + r"\d+", name)]
    if not copies:
        raise ValueError(f"replicate: expected geoms named {prefix}0, {prefix}1, ..., got none")
    return "\n      ".join(_place(inner.strip(), prefix, model.geom(name)) for name in copies)


def _get_name(inner: str) -> str:
    found = re.fullmatch(r"\s*<geom [^>]*\bname=\"([^\"]+)\"[^>]*/>\s*", inner)
    if not found:
        raise ValueError(f"replicate: expected one geom with a name in it, got {inner.strip()}")
    return found[1]


def _place(element: str, prefix: str, geom: mujoco._structs._MjModelGeomViews) -> str:
    """Give a geom the name and the pose of one of its copies."""
    pos, quat = (" ".join(map(repr, one.tolist())) for one in (geom.pos, geom.quat))
    element = element.replace(f'name="{prefix}"', f'name="{geom.name}"')
    return re.sub(r" pos=\"[^\"]*\"", f' pos="{pos}" quat="{quat}"', element)
