"""Sections for the curious: the heading and a sentence stay, the rest folds away."""

from __future__ import annotations

import re
from types import ModuleType

import pytest
from docutils import nodes
from docutils.utils import new_document
from sphinx.errors import ExtensionError

from tests.helpers.chapters import ROOT, find_pages
from tests.helpers.scripts import load_script


@pytest.fixture
def hook() -> ModuleType:
    return load_script("book/_ext/folded.py")


def make_page(title: str, *parts: nodes.Element) -> tuple[nodes.document, nodes.section]:
    """Make a page with one section."""
    tree = new_document("page")
    section = nodes.section("", nodes.title("", title), *parts, ids=["here"])
    tree.append(section)
    return tree, section


def test_what_follows_the_first_paragraph_is_folded(hook: ModuleType) -> None:
    stays, cell = nodes.paragraph("", "It is small."), nodes.container(classes=["cell"])
    tree, section = make_page("For the curious: why?", stays, cell, nodes.paragraph("", "So."))
    hook.fold_sections(None, tree, "page")
    title, first, fold = section.children
    assert (title.astext(), first) == ("For the curious: why?", stays)
    assert isinstance(fold, hook.Folded)
    assert fold.children[0] is cell
    assert fold.children[1].astext() == "So."


def test_other_sections_stay_as_they_are(hook: ModuleType) -> None:
    tree, section = make_page("Why are you curious?", nodes.paragraph("", "One."), nodes.image())
    hook.fold_sections(None, tree, "page")
    assert [type(child) for child in section] == [nodes.title, nodes.paragraph, nodes.image]


@pytest.mark.parametrize(
    "parts", [[], [nodes.paragraph("", "Alone.")], [nodes.image(), nodes.paragraph("", "Late.")]]
)
def test_a_section_without_a_sentence_or_without_a_rest_is_refused(
    hook: ModuleType, parts: list[nodes.Element]
) -> None:
    tree, _ = make_page("For the curious: why?", *parts)
    with pytest.raises(ExtensionError, match=r"page, 'For the curious: why\?': expected a paragr"):
        hook.fold_sections(None, tree, "page")


def test_the_built_pages_fold_every_such_section() -> None:
    html = ROOT / "_build" / "html"
    if not html.is_dir():
        pytest.skip("the book is not built: make book")
    asked = {
        page: text.count("\n### For the curious")
        for page in find_pages()
        if "\n### For the curious" in (text := (ROOT / page).with_suffix(".md").read_text("utf-8"))
    }
    assert asked, "expected at least one section for the curious"
    for page, count in asked.items():
        built = (html / page).with_suffix(".html").read_text("utf-8")
        folds = re.findall(r'<details class="curious">\n<summary>Show this part</summary>', built)
        assert len(folds) == count, page
