"""The concept questions, and the view that many of them are about."""

from __future__ import annotations

from typing import Any

import labutils as lab
from content.quiz_items import Item, load_all

ITEMS = {item.id: item for items in load_all().values() for item in items}
SIZE = (480, 640)
HEAD = "head_camera"


def get_numbers(item: Item) -> list[float]:
    """List the number that each choice begins with, the right one first."""
    return [float(text.split()[0]) for text in get_texts(item)]


def get_texts(item: Item) -> list[str]:
    """List what the choices say, the right one first."""
    return [choice.text for choice in sorted(item.choices, key=lambda choice: not choice.right)]


def make_view() -> dict[str, Any]:
    """Render color, depth and bodies of the head camera, all of one moment."""
    model, data = lab.make_scene()
    with lab.make_renderer(model, *SIZE) as renderer:
        rgb, depth = lab.render_camera(model, data, renderer, HEAD)
        bodies = lab.render_segmentation(model, data, renderer, HEAD)
    K, _ = lab.get_camera_intrinsics(model, HEAD, SIZE[1], SIZE[0])
    return {"model": model, "data": data, "rgb": rgb, "depth": depth, "bodies": bodies, "K": K}
