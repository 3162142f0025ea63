"""Exercise cells on the built pages: plain without scripts, and all that the scripts need."""

import json
import re
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import pytest
from docutils import nodes
from docutils.frontend import get_default_settings
from docutils.utils import new_document
from sphinx.errors import ExtensionError

from labutils.checks.progress_rules import MAX_HINTS
from labutils.checks.table import load_table, read_completions, read_words
from tests.book.test_build_config import load
from tests.helpers.chapters import get_toc_pages

ROOT = Path(__file__).resolve().parents[2]
HTML = ROOT / "_build" / "html"
EXERCISES = read_words()
TWINS = read_completions()
DATA = re.compile(r'<script type="application/json" id="exercise-data">(.*?)</script>', re.DOTALL)


@pytest.fixture
def hook(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    return load("book/_ext/exercise_cells.py", monkeypatch)


@pytest.fixture(scope="module")
def pages() -> dict[str, str]:
    if not (HTML / "index.html").is_file() or not (HTML / "_static" / "python").is_dir():
        pytest.skip("the book is not built; run `make book` first")
    found = {path.stem: path.read_text() for path in sorted((HTML / "exercises").glob("*.html"))}
    assert set(found) == {page.name for page in get_toc_pages() if page.parts[0] == "exercises"}
    return found


@pytest.fixture(scope="module")
def data(pages: dict[str, str]) -> dict[str, Any]:
    read = {}
    for name, page in pages.items():
        found = DATA.search(page)
        assert found is not None, name
        read[name] = json.loads(found[1])
    return read


def make_tree(*exercises: tuple[str, str]) -> nodes.document:
    """Make a page as MyST leaves it: per exercise a cell, its check, a comment and a hint."""
    tree = new_document("page", get_default_settings())
    top = nodes.section()
    tree += top
    for name, checked in exercises:
        section = nodes.section()
        section += nodes.container(
            "", nodes.literal_block("", ""), classes=["cell", "tag_exercise"]
        )
        code = nodes.literal_block("", f'check("{name}", {checked})')
        section += nodes.container("", code, classes=["cell"])
        section += nodes.comment("", "end")
        section += nodes.container("", nodes.paragraph("", "hint"), classes=["dropdown"])
        top += section
    return tree


def make_app() -> SimpleNamespace:
    domain = SimpleNamespace(labels={}, anonlabels={})
    return SimpleNamespace(
        builder=SimpleNamespace(format="html"),
        env=SimpleNamespace(get_domain=lambda _: domain),
    )


def get_raw(tree: nodes.document) -> list[str]:
    return [node.astext() for node in tree.findall(nodes.raw)]


def test_the_parts_of_an_exercise_are_marked(hook: ModuleType) -> None:
    tree = make_tree(("process_depth", "process_depth"))
    hook.mark_cells(make_app(), tree, "exercises/page")
    assert tree["exercises"] == ["process_depth"]
    (section,) = list(tree.findall(nodes.section))[1:]
    mount, cell, check, _, hint = section.children
    assert 'data-exercise="process_depth" hidden' in mount.astext()
    assert "exercise-source-process_depth" in cell["classes"]
    assert "exercise-check-process_depth" in check["classes"]
    assert "exercise-hint-process_depth" in hint["classes"]
    assert "exercise-bar" in tree.children[0].children[0].astext()


def test_a_completion_has_no_hint_and_does_not_take_what_follows(hook: ModuleType) -> None:
    tree = make_tree(("color_heights", "color_heights"))
    (section,) = list(tree.findall(nodes.section))[1:]
    section.children[0]["classes"].append("tag_completion")
    hook.mark_cells(make_app(), tree, "exercises/page")
    mount, cell, check, _, following = section.children
    assert 'class="exercise is-completion" data-exercise="color_heights"' in mount.astext()
    assert "exercise-source-color_heights" in cell["classes"]
    assert "exercise-check-color_heights" in check["classes"]
    assert following["classes"] == ["dropdown"]


def test_a_page_without_exercises_stays_as_it_is(hook: ModuleType) -> None:
    tree = make_tree()
    hook.mark_cells(make_app(), tree, "book/page")
    assert tree["exercises"] == []
    assert get_raw(tree) == []


@pytest.mark.parametrize(
    ("name", "checked"),
    [("process_depth", "something_else"), ("no_such_exercise", "no_such_exercise")],
)
def test_a_cell_without_its_check_stops_the_build(
    hook: ModuleType, name: str, checked: str
) -> None:
    tree = make_tree((name, checked))
    with pytest.raises(ExtensionError, match=r"expected check\(.*after a cell tagged exercise"):
        hook.mark_cells(make_app(), tree, "exercises/page")


def test_a_link_of_a_check_that_leads_nowhere_stops_the_build(hook: ModuleType) -> None:
    with pytest.raises(ExtensionError, match=r"process_depth: its check links to .*, which is"):
        hook.get_titles(make_app(), ["process_depth"])


def test_other_formats_than_html_are_left_alone(hook: ModuleType) -> None:
    tree = make_tree(("process_depth", "process_depth"))
    hook.mark_cells(SimpleNamespace(builder=SimpleNamespace(format="latex")), tree, "page")
    assert get_raw(tree) == []


def test_every_exercise_has_an_editor(pages: dict[str, str]) -> None:
    mounted = [
        name
        for page in pages.values()
        for name in re.findall(r'data-exercise="(\w+)" hidden', page)
    ]
    assert sorted(mounted) == sorted([*EXERCISES, *TWINS])


def test_without_scripts_the_exercise_can_be_read(pages: dict[str, str]) -> None:
    parts = r"<[^>]*\bexercise-(?:source|check|hint)-[^>]*>"
    text = "".join(re.sub(r"<[^<>]*>", "", page) for page in pages.values())
    for name in (*EXERCISES, *TWINS):
        assert f"def {name}(" in text
        assert f'check("{name}", {name})' in text
    for page in pages.values():
        elements = re.findall(parts, page)
        assert elements
        assert not [element for element in elements if "hidden" in element]


def test_pages_know_hints_tables_and_titles(data: dict[str, Any]) -> None:
    names = [name for page in data.values() for name in page["exercises"]]
    assert sorted(names) == sorted([*EXERCISES, *TWINS])
    for page in data.values():
        assert sorted(page["tables"]) == sorted(page["exercises"])
        for name, known in page["exercises"].items():
            words = (TWINS if name in TWINS else EXERCISES)[name]
            assert known["isCompletion"] == (name in TWINS)
            assert known["hints"] == words["hints"]
            assert len(known["hints"]) == (0 if name in TWINS else MAX_HINTS)
            assert ("simulator" in known["parts"]) == load_table(name).needs_mujoco
            assert page["titles"][words["section"]]


def test_links_of_verdicts_lead_to_a_place(data: dict[str, Any]) -> None:
    for page in data.values():
        assert page["titles"]
        for link in page["titles"]:
            target, _, anchor = link.partition("#")
            assert f'id="{anchor}"' in (HTML / "exercises" / target).read_text()


def test_the_table_of_every_exercise_is_there(data: dict[str, Any]) -> None:
    for page in data.values():
        for asset in page["tables"].values():
            assert asset["files"]
            assert all((HTML / "_static" / "python" / file).is_file() for file in asset["files"])
