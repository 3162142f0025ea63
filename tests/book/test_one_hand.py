"""All steps are written by one hand: the same imports, the same sections, the same form of each."""

from __future__ import annotations

import re

import pytest

from content.chapters import list_taught
from tests.helpers.chapters import ROOT

STEPS = [chapter for chapter in list_taught() if chapter.kind == "required"]
PAGES = {step.id: (ROOT / f"{step.page}.md").read_text(encoding="utf-8") for step in STEPS}
CELL = re.compile(
    r"^```\{code-cell\}[^\n]*\n(?:---\n.*?^---\n)?(.*?)^```$", re.DOTALL | re.MULTILINE
)
WHERE = re.compile(r"\A\| \| what \| type \|\n\|---\|---\|---\|\n(\| (in|out) \|.*\n){2,}\n*\Z")


def get_section(page: str, heading: str) -> str:
    """Return what stands below a heading of the second level."""
    return PAGES[page].partition(f"\n## {heading}\n")[2].partition("\n## ")[0]


@pytest.mark.parametrize("page", PAGES)
def test_the_set_up_imports_everything_but_explorers(page: str) -> None:
    first, *others = CELL.findall(PAGES[page])
    assert "\nimport labutils as lab\n" in first
    imports = r"^(?!from labutils\.explorers )(?:import|from) .*"
    late = [line for cell in others for line in re.findall(imports, cell, re.MULTILINE)]
    assert not late, f"expected these in the first cell: {late}"


@pytest.mark.parametrize("page", PAGES)
def test_calls_of_the_library_say_so(page: str) -> None:
    assert "from labutils import " not in PAGES[page], "expected `lab.` before names of the library"


@pytest.mark.parametrize("page", PAGES)
def test_a_robot_asks_and_the_objectives_answer(page: str) -> None:
    section = get_section(page, "Question and objectives")
    assert re.match(r"\*A robot asks: .+\?\*\n\nAfter this step you can:\n\n- \*\*", section)
    items = re.findall(r"^- \*\*\d[a-e]\.\*\* .*$", section, re.MULTILINE)
    assert [item[-1] for item in items] == [";"] * (len(items) - 1) + ["."]


@pytest.mark.parametrize("page", PAGES)
def test_where_we_are_is_a_table_of_what_goes_in_and_out(page: str) -> None:
    assert WHERE.match(get_section(page, "Where we are"))


@pytest.mark.parametrize("page", PAGES)
def test_common_errors_say_what_is_seen_its_cause_and_its_cure(page: str) -> None:
    section = get_section(page, "Common errors")
    assert ":::" not in section, "a box is for one mistake in the middle of the text"
    errors = re.findall(r"^\*\*(.+?)\.\*\* (.*)$", section, re.MULTILINE)
    assert len(errors) >= 2
    for seen, rest in errors:
        assert re.search(r"Cause: .+ Cure: ", rest), f"expected a cause and a cure of: {seen}"
