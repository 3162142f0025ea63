"""Give widgets the same ids in every build.

ipywidgets names its models with random ids, and stores them sorted by these, so two
builds of one commit would differ. Here they are renamed, page by page, in the order
in which the page shows them.
"""

import json
import re
import uuid
from typing import Any

from sphinx.application import Sphinx

WIDGET_STATE = "application/vnd.jupyter.widget-state+json"
VIEW = re.compile(r'(<script type="application/vnd\.jupyter\.widget-view\+json">)(.*?)(</script>)')
MODEL_ID = re.compile(r"(?<![0-9a-f])[0-9a-f]{32}(?![0-9a-f])")  # also in "IPY_MODEL_<id>"


def order_of_models(models: dict[str, Any], body: str) -> list[str]:
    """List the ids of the models: as shown on the page, each followed by its parts.

    Models that no shown model names (links between two widgets name others, but are
    not named) come last, ordered by what they say.
    """
    texts = {key: json.dumps(model, sort_keys=True) for key, model in models.items()}
    order: dict[str, int] = {}  # a dict for its order and its fast look-up

    def visit(key: str) -> None:
        if key in texts and key not in order:
            order[key] = len(order)
            for part in MODEL_ID.findall(texts[key]):
                visit(part)

    def content(key: str) -> str:
        return MODEL_ID.sub(lambda match: f"#{order.get(match[0], '?')}", texts[key])

    for view in VIEW.finditer(body):
        for key in MODEL_ID.findall(view[2]):
            visit(key)
    for key in sorted(texts.keys() - order.keys(), key=content):
        visit(key)
    return list(order)


def rename_models(
    _app: Sphinx, pagename: str, _templatename: str, context: dict[str, Any], _doctree: object
) -> None:
    """Rename the models in the body of a page and in its widget state."""
    body = context.get("body", "")
    for script in context.get("script_files", ()):
        attributes = getattr(script, "attributes", {})
        if attributes.get("type") != WIDGET_STATE:
            continue
        state = json.loads(attributes["body"])
        order = order_of_models(state["state"], body)
        names = {
            old: uuid.uuid5(uuid.NAMESPACE_URL, f"{pagename}#{place}").hex
            for place, old in enumerate(order)
        }
        attributes["body"] = _renamed(attributes["body"], names)
        context["body"] = _rename_views(body, names)


def _rename_views(body: str, names: dict[str, str]) -> str:
    return VIEW.sub(lambda view: view[1] + _renamed(view[2], names) + view[3], body)


def _renamed(text: str, names: dict[str, str]) -> str:
    """Rename the models in some JSON, and sort it: the order of the old names was random."""
    content = json.loads(MODEL_ID.sub(lambda match: names.get(match[0], match[0]), text))
    return json.dumps(content, sort_keys=True).replace("</script>", r"<\/script>")


def setup(app: Sphinx) -> dict[str, Any]:
    """Connect the hook to Sphinx."""
    app.connect("html-page-context", rename_models, priority=900)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
