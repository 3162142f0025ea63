"""Give widgets the same ids in every build.

ipywidgets names its models with random ids, so two builds of one commit would
differ. They are renumbered here, per page, in the order in which they appear.
"""

import re
import uuid

WIDGET_STATE = "application/vnd.jupyter.widget-state+json"
MODEL_ID = re.compile(r"(?<![0-9a-f])[0-9a-f]{32}(?![0-9a-f])")  # also in "IPY_MODEL_<id>"


def stable_names(state_text, page):
    """Map each model id of a page to one made from the page name and its place."""
    found = dict.fromkeys(MODEL_ID.findall(state_text))
    return {old: uuid.uuid5(uuid.NAMESPACE_URL, f"{page}#{k}").hex for k, old in enumerate(found)}


def rename_models(app, pagename, templatename, context, doctree):
    """Rename the models in the body of a page and in its widget state."""
    states = [
        script
        for script in context.get("script_files", ())
        if getattr(script, "attributes", {}).get("type") == WIDGET_STATE
    ]
    if not states:
        return
    text = "".join(script.attributes["body"] for script in states)
    names = stable_names(text, pagename)

    def rename(match):
        return names.get(match[0], match[0])

    for script in states:
        script.attributes["body"] = MODEL_ID.sub(rename, script.attributes["body"])
    context["body"] = MODEL_ID.sub(rename, context["body"])


def setup(app):
    """Connect the hook to Sphinx."""
    app.connect("html-page-context", rename_models, priority=900)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
