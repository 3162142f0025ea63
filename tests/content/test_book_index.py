"""The index of terms, functions and errors: found in the pages, so never stale."""

from __future__ import annotations

from pathlib import Path

import pytest

import labutils
from content.book_index import Page, list_errors, list_functions, list_terms, make_index

PAGE = """(page-one)=
# Step 1: What?

A {term}`mask`, and again a {term}`mask`.

(one-first)=
## First

Two {term}`masks <mask>` and an {term}`edge`.

```{code-cell} ipython3
# label("in a comment of a cell is a call too")
x = lab.look(3)
```

### Below it

An {term}`odd one`.

## Without a label

A {term}`late one`. Call `see(1)` here.

## Common errors
**The picture is empty.** Cause: this. **K is wrong.** Cause: that.

**K is wrong.** Cause: that.

:::{admonition} Pitfall: colors swapped
:class: pitfall
:::

## Recap
A {term}`repeated one`.
"""
TABLE = "| You see | Go to |\n|---|---|\n| a `TypeError` | {ref}`ts-type` |\n"
GLOSSARY = "# Glossary\n\n:::{glossary}\n" + "".join(
    f"{term}\n  What it means.\n\n"
    for term in ("mask", "edge", "Axis", "odd one", "late one", "repeated one")
)


@pytest.fixture
def pages() -> list[Page]:
    return [Page("one", PAGE), Page("help", f"(page-help)=\n# Help: what?\n\n{TABLE}")]


def test_a_term_leads_to_the_section_that_names_it_first(pages: list[Page]) -> None:
    assert list_terms(pages, GLOSSARY) == [
        "| {term}`edge` | {ref}`Step 1 <one-first>` |",
        "| {term}`late one` | {ref}`Step 1 <page-one>` |",
        "| {term}`mask` | {ref}`Step 1 <page-one>` |",
        "| {term}`odd one` | {ref}`Step 1 <one-first>` |",
    ]


def test_a_function_counts_where_a_cell_calls_it(pages: list[Page]) -> None:
    rows = list_functions(pages, ["look", "see", "unknown"])
    assert rows == ["| `look` | {ref}`Step 1 <one-first>` |"]


def test_symptoms_come_first_and_then_errors_page_by_page(pages: list[Page]) -> None:
    assert list_errors(pages) == [
        "| a `TypeError` | {ref}`ts-type` |",
        "| the picture is empty | {ref}`Step 1 <one-errors>` |",
        "| K is wrong | {ref}`Step 1 <one-errors>` |",
        "| colors swapped | {ref}`Step 1 <one-errors>` |",
    ]


def test_the_index_of_the_book_holds_what_its_pages_teach() -> None:
    names = [name for name in labutils.__all__ if not name[0].isupper()]
    tables = make_index(names)
    assert list(tables) == ["terms", "functions", "errors"]
    for term in ("kernel", "erosion", "dilation", "frustum", "azimuth", "least squares", "site",
                 "OpenGL context", "IoU"):  # fmt: skip
        assert f"| {{term}}`{term}` |" in tables["terms"], f"{term}: no page links to it"
    for name in ("render_camera", "process_depth", "segment_by_color", "depth_to_pointcloud"):
        assert f"| `{name}` |" in tables["functions"]
    for step in range(1, 7):
        assert f"{{ref}}`Step {step} <step{step}_" in tables["errors"]


def test_pages_that_only_list_or_cite_are_left_out(tmp_path: Path) -> None:
    (tmp_path / "book").mkdir()
    toc = "root: book/index\nparts:\n- chapters:\n  - file: book/one\n  - file: book/glossary\n"
    (tmp_path / "_toc.yml").write_text(toc, encoding="utf-8")
    for name, text in {"index": PAGE, "one": PAGE, "glossary": GLOSSARY}.items():
        (tmp_path / "book" / f"{name}.md").write_text(text, encoding="utf-8")
    rows = make_index(["look"], tmp_path)["functions"].splitlines()[2:]
    assert rows == ["| `look` | {ref}`Step 1 <one-first>` |"]
