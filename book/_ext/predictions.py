"""Prepare the predictions of a page: what is said to each answer, and what covers until then.

A box of the class ``predict`` stays what it is, a text with its choices, for notebooks, paper and
readers without scripts. Here it gets, hidden, what ``exercises/predictions`` has to say, and the
parts of the page that hold the answer are marked. ``predict.js`` makes a form of the box, and
covers those parts until the reader has answered.
"""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from docutils import nodes
from docutils.parsers.rst.directives.admonitions import Admonition
from docutils.statemachine import StringList
from sphinx.application import Sphinx
from sphinx.errors import ExtensionError

from content import predictions
from quiz import tag

SCRIPTS = ("predict_fields.js", "predict.js")
ANSWER = "predict-answer-{}"  # class of what a box covers


# docutils has no types
class PredictBox(Admonition):  # type: ignore[misc]
    """A box; one of the class ``predict`` is told what is right."""

    def run(self) -> list[Any]:
        """Return the box."""
        name = str(self.options.get("name", "none"))  # which the box takes for its own
        made: list[Any] = super().run()
        if "predict" not in made[0].get("classes", ()):
            return made
        env = self.state.document.settings.env
        page = Path(env.docname).name
        try:
            known = predictions.load_page(page)
        except predictions.PredictionError as problem:
            raise self.error(str(problem)) from problem
        # Sphinx reads the page again when an answer or the reader of answers changes
        for source in (predictions.PREDICTIONS / f"{page}.yml", Path(predictions.__file__)):
            env.note_dependency(str(source))
        item = known.get(name.removeprefix("predict-"))
        if item is None:
            raise self.error(
                f"exercises/predictions/{page}.yml: expected an item for this box, by its "
                f":name: predict-<id>, got {name}"
            )
        (box,) = made
        box["prediction"] = item
        self._check_choices(box, item)
        box += self._make_said(item)
        return made

    def _check_choices(self, box: Any, item: predictions.Prediction) -> None:
        lists = [child for child in box.children if isinstance(child, nodes.enumerated_list)]
        counts = [len(one.children) for one in lists]
        if counts != ([] if item.right is None else [len(item.said)]):
            wanted = "no numbered list" if item.right is None else f"{len(item.said)} choices"
            raise self.error(f"{item.name}: expected {wanted} in the box, got lists of {counts}")

    def _make_said(self, item: predictions.Prediction) -> nodes.Node:
        """Everything there is to say, hidden; predict.js shows the part that is asked for."""
        said = [
            tag.make("p", *self._parse_line(text), data_answer=answer)
            for answer, text in item.said.items()
        ]
        right: dict[str, str | bool] = {"data_right": str(item.right)}
        if item.number:
            right = {
                "data_number": f"{item.number.value:g}",
                "data_unit": item.number.unit,
                "data_tolerance": f"{item.number.tolerance:g}",
            }
        return tag.make("div", *said, class_="predict-said", hidden=True, **right)

    def _parse_line(self, text: str) -> list[nodes.Node]:
        """Turn MyST of one paragraph into the nodes inside it."""
        holder = nodes.Element()
        self.state.nested_parse(StringList(text.splitlines(), self.src), 0, holder)
        if len(holder.children) != 1 or not isinstance(holder.children[0], nodes.paragraph):
            raise self.error(f"expected one paragraph in the prediction: {text!r}")
        return holder.children[0].children

    @property
    def src(self) -> str:
        """The file the box stands in."""
        return str(self.state.document.current_source)


def mark_answers(app: Sphinx, tree: nodes.document, page: str) -> None:
    """Mark what every box of a page covers.

    Raises
    ------
    ExtensionError
        If a prediction has no box, or a box covers nothing.
    """
    folder, _, stem = page.rpartition("/")
    if app.builder.format != "html" or folder.endswith("exercises"):  # pages of the same names
        return
    boxes = [box for box in tree.findall(nodes.admonition) if "prediction" in box]
    asked = [box["prediction"].id for box in boxes]
    known = predictions.load_page(stem)
    if sorted(asked) != sorted(known):
        raise ExtensionError(
            f"{page}: expected a box for each of {', '.join(sorted(known))}, "
            f"got {', '.join(sorted(asked)) or 'none'}"
        )
    for box in boxes:
        item = box["prediction"]
        covered = list(find_covered(box, item, page))
        if not covered:
            raise ExtensionError(f"{page}, {item.name}: expected an output or a text to cover")
        cover(covered, ANSWER.format(item.id))
    tree["predictions"] = asked


def find_covered(
    box: nodes.admonition, item: predictions.Prediction, page: str
) -> Iterator[nodes.Element]:
    """Find what a box covers: up to the next heading or box, or to the part that is named.

    Raises
    ------
    ExtensionError
        If no part begins as named, or the next prediction comes before it.
    """
    after = box.parent.children[box.parent.index(box) + 1 :]
    for node in after:
        if isinstance(node, nodes.section) or "prediction" in getattr(node, "attributes", ()):
            break
        if item.until is None and isinstance(node, nodes.admonition):
            return
        if item.until and node.astext().lstrip("# ").startswith(item.until):
            return
        if isinstance(node, nodes.Element):
            yield node
    if item.until is not None:
        raise ExtensionError(
            f"{page}, {item.name}: expected a part that begins with {item.until!r} before the "
            "next heading or prediction, got none"
        )


def cover(covered: list[nodes.Element], name: str) -> None:
    """Mark cells, whose code stays in view, and put the texts between them into elements."""
    texts: list[nodes.Element] = []

    def wrap() -> None:
        if not texts:
            return
        parent, place = texts[0].parent, texts[0].parent.index(texts[0])
        for one in texts:
            parent.remove(one)
        parent.insert(place, tag.make("div", *texts, class_=f"predict-answer {name}"))
        texts.clear()

    for node in covered:
        if "cell" in node.get("classes", ()):
            wrap()
            node["classes"] += ["predict-cell", name]
        elif texts or not isinstance(node, nodes.target | nodes.comment):
            texts.append(node)
    wrap()


def add_script(
    app: Sphinx, _page: str, _template: str, _context: dict[str, Any], tree: nodes.document | None
) -> None:
    """Load the scripts on pages with predictions."""
    if tree is not None and tree.get("predictions"):
        for script in SCRIPTS:
            app.add_js_file(script, defer="defer")


def setup(app: Sphinx) -> dict[str, Any]:
    """Name the box to Sphinx, and connect the hooks."""
    app.setup_extension("quiz")  # for its element
    app.add_directive("admonition", PredictBox, override=True)
    app.connect("doctree-resolved", mark_answers)
    app.connect("html-page-context", add_script)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
