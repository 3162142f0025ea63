"""Find the explorers of the book, and make their views again from what a built page holds."""

from __future__ import annotations

import base64
import json
import re
from typing import Any

from content import toc
from labutils import explorers
from labutils.explorers._base import View
from tools import ROOT

STATE = re.compile(
    r'<script type="application/vnd\.jupyter\.widget-state\+json">(.*?)</script>', re.DOTALL
)


def find_pages() -> list[str]:
    """List the pages that show explorers."""
    return [
        page
        for page in toc.list_pages()
        if "from labutils.explorers import" in (ROOT / page).with_suffix(".md").read_text("utf-8")
    ]


def read_views(html: str) -> list[View]:
    """Make the views of a page again, from what the page holds of them, in the page's order."""
    found = STATE.search(html)
    if found is None:
        raise ValueError("expected a page with explorers, got one without their state")
    models = json.loads(found[1])["state"]
    classes = {f"{one.__module__}.{one.__qualname__}": one for one in find_view_classes()}
    shown = re.findall(r'"model_id": "(\w+)"', html)
    boxes = [models[one]["state"] for one in shown if "children" in models[one]["state"]]
    first = [models[box["children"][0].removeprefix("IPY_MODEL_")] for box in boxes]
    return [make_view(classes[model["state"]["_anywidget_id"]], model) for model in first]


def find_view_classes() -> list[type[View]]:
    """List the views that the explorers show; what they have in common is none."""
    return [one for one in _find_below(View) if _is_shown(one)]


def _is_shown(view_class: type[View]) -> bool:
    package, _, module = view_class.__module__.rpartition(".")
    return package == explorers.__name__ and not module.startswith("_")


def _find_below(view_class: type[View]) -> list[type[View]]:
    return [one for child in view_class.__subclasses__() for one in (child, *_find_below(child))]


def make_view(view_class: type[View], model: dict[str, Any]) -> View:
    """Make one view from its traits; what it shows first has to be what the page showed."""
    traits = {
        name: value
        for name, value in model["state"].items()
        if name in view_class.class_trait_names(sync=True) and not name.startswith("_")
    }
    traits.pop("layout", None)
    for buffer in model.get("buffers", []):
        (name,) = buffer["path"]
        traits[name] = base64.b64decode(buffer["data"])
    start = traits.pop("start")
    view = view_class(**{k: v for k, v in traits.items() if k not in ("tabbable", "tooltip")})
    if view.start != start:
        raise AssertionError(f"{view_class.__name__}: starts with {view.start}, not {start}")
    return view
