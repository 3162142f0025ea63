"""Draw the path through the book: one row per chapter, with its minutes and its exercises.

The directive ``path`` stands where the rows should be. ``path.js`` adds how far the reader is, from
the progress that this browser keeps; without scripts and on paper the rows stand alone.
"""

from collections.abc import Callable
from html import escape
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

from content import chapters, page_minutes, predictions, quiz_items
from content.path import (
    Leg,
    Task,
    add_minutes,
    get_minimal_minutes,
    get_strong_minutes,
    read_path,
    say_hours,
)
from labutils.checks.table import TABLES, WORDS, read_words

HOW = ("book/start", "start-time")  # where the minutes are explained
PLACE = "path-place"  # class of what stands there until links are known
SCRIPT = "path_rows.js"
AFTER_PATH_JS = 900  # what the configuration names, comes with 800
LinkTo = Callable[[str], str]


class PathDirective(SphinxDirective):
    """The whole path."""

    def run(self) -> list[nodes.Node]:
        """Return the place of the rows."""
        # Sphinx reads the page again when what is counted changes
        pages = [f"{one.page}.md" for one in chapters.load_chapters()]
        registry = chapters.REGISTRY.as_posix()
        for source in (str(TABLES / WORDS), page_minutes.__file__, registry, *pages):
            self.env.note_dependency(str(Path(self.env.srcdir, source)))
        return [nodes.container(classes=[PLACE])]


def fill_places(app: Sphinx, tree: nodes.document, page: str) -> None:
    """Put the rows where a page asks for them."""
    for place in list(tree.findall(nodes.container)):
        if PLACE not in place["classes"]:
            continue
        html = ""
        if app.builder.format == "html":
            link_to = lambda other: app.builder.get_relative_uri(page, other)  # noqa: E731
            html = make_path(read_path(read_words()), link_to)
        # not replace_self, which hands its class on
        place.parent.replace(place, nodes.raw("", html, format="html"))
        tree["has_path"] = True


def add_script(
    app: Sphinx,
    _pagename: str,
    _templatename: str,
    _context: dict[str, Any],
    doctree: nodes.document | None,
) -> None:
    """Load what tells how far the reader is, on pages with rows."""
    if doctree is not None and doctree.get("has_path"):
        app.add_js_file(SCRIPT, priority=AFTER_PATH_JS, defer="defer")


def make_path(path: tuple[Leg, ...], link_to: LinkTo) -> str:
    """Return the path as HTML.

    Parameters
    ----------
    path : tuple of Leg
        What ``read_path`` gives.
    link_to : callable
        Turns a page name into a relative link.
    """
    required = sum(len(leg.required) for leg in path)
    challenges = sum(len(leg.optional) for leg in path if not leg.chapter.is_extension)
    page, anchor = HOW
    return (
        '<div class="path is-wide">'
        f"<p>The <strong>minimal path</strong> takes {say_hours(get_minimal_minutes(path))}: the "
        f"steps and their {required} required exercises. The <strong>strong path</strong> adds "
        f"the pages marked optional and {challenges} challenges: "
        f"{say_hours(get_strong_minutes(path))} in all. "
        f'<a href="{escape(link_to(page))}#{anchor}">How the minutes are counted</a></p>'
        '<p class="path-on" hidden></p><ol role="list">'
        + "".join(_make_row(leg, link_to) for leg in path)
        + "</ol></div>\n"
    )


def _make_row(leg: Leg, link_to: LinkTo) -> str:
    chapter = leg.chapter
    marks = {
        "required": " ".join(one.name for one in leg.required),
        "optional": " ".join(one.name for one in leg.optional),
        "questions": " ".join(_list_questions(chapter.stem)),
        "predictions": " ".join(predictions.load_page(chapter.stem)),
        "exercises": link_to(chapter.exercises) if chapter.exercises else "",
        "skip": "" if leg.is_required else "true",
    }
    data = "".join(f' data-{name}="{escape(text)}"' for name, text in marks.items() if text)
    exercises = [_describe(leg.required, "required"), _describe(leg.optional, "challenge")]
    facts = [f"Read {leg.minutes.reading} min, do {leg.minutes.doing} min"]
    if any(exercises):
        link = f'<a href="{escape(marks["exercises"])}">Exercises</a>'
        facts.append(f"{link}: {', '.join(filter(None, exercises))}")
    elif not leg.is_required:
        facts.append("Optional: skip what you know")
    return (
        f'<li{data}><a class="path-title" href="{escape(link_to(chapter.page))}">'
        f"{escape(chapter.heading)}</a>"
        f'<span class="path-facts">{". ".join(facts)}.</span>'
        '<span class="path-done" hidden></span></li>'
    )


def _describe(tasks: tuple[Task, ...], word: str) -> str:
    if not tasks:
        return ""
    plural = "s" if word == "challenge" and len(tasks) > 1 else ""
    return f"{len(tasks)} {word}{plural} ({add_minutes(tasks)}&nbsp;min)"


def _list_questions(page: str) -> list[str]:
    """Name the questions of a page, which may have none."""
    known = page in quiz_items.list_pages()
    return [item.id for item in quiz_items.load_page(page)] if known else []


def setup(app: Sphinx) -> dict[str, Any]:
    """Name the directive to Sphinx, and connect the hooks."""
    app.add_directive("path", PathDirective)
    app.connect("doctree-resolved", fill_places)
    app.connect("html-page-context", add_script)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
