"""Nothing is written that nobody can find: pages, widgets, images, objectives."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from solutions import load_exercises
from tests.helpers.chapters import ROOT, find_orphans, find_pages, get_toc_pages

STEPS = [page for page in get_toc_pages() if page.match("book/step*")]
EXERCISES = [page for page in get_toc_pages() if page.parts[0] == "exercises"]
STARTER = r"^```\{code-cell\}[^\n]*\n:tags: \[exercise\]\n.*?^```$"
PAGES = find_pages()


def read(page: Path) -> str:
    """The text of a page."""
    return (ROOT / page).with_suffix(".md").read_text(encoding="utf-8")


def test_every_page_and_widget_can_be_reached():
    assert find_orphans() == []


def test_an_orphan_of_every_kind_is_noticed(tmp_path):
    (tmp_path / "_toc.yml").write_text(
        "root: book/index\nparts:\n- chapters:\n  - file: book/gone\n  - file: book/index\n",
        encoding="utf-8",
    )
    (tmp_path / "labutils" / "explorers").mkdir(parents=True)
    (tmp_path / "labutils" / "explorers" / "fov.py").touch()
    for name in ("book/index.md", "book/lost.md", "exercises/lost.md", "book/_generated/part.md"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).touch()
    assert find_orphans(tmp_path) == [
        "page book/lost is not in _toc.yml",
        "page exercises/lost is not in _toc.yml",
        "page book/gone in _toc.yml does not exist",
        "page book/index is in _toc.yml twice",
        "widget fov is on no page",
        "widget fov has no test",
    ]


@pytest.mark.parametrize("page", PAGES, ids=str)
def test_every_picture_says_its_finding_in_words(page):
    text = read(page)
    figures = re.findall(
        r"^[`:]{3,}\{(?:figure|image)\}.*?^[`:]{3,}$", text, re.DOTALL | re.MULTILINE
    )
    for figure in figures:
        assert re.search(r"^:alt: [^\n]{20,}", figure, re.MULTILINE), figure
    for cell in re.findall(r"^```\{code-cell\}.*?^```$", text, re.DOTALL | re.MULTILINE):
        last = [line for line in cell.splitlines() if line.strip()][-2]
        if re.match(r"(figures\.)?(plot_|visualize_pointcloud)", last):
            assert re.search(r"alt: .{20,}", cell), cell
    assert not re.search(r"!\[\]\(", text), "an image without words"


@pytest.mark.parametrize("page", STEPS, ids=str)
def test_the_recap_answers_the_objectives_one_by_one(page):
    number = page.name[4]
    text = read(page)
    head, _, tail = text.partition("## Recap")
    pattern = rf"^- \*\*({number}[a-e])\.\*\* "
    objectives = re.findall(pattern, head, re.MULTILINE)
    assert 3 <= len(objectives) <= 5
    assert re.findall(pattern, tail, re.MULTILINE) == objectives


@pytest.mark.parametrize("page", STEPS, ids=str)
def test_steps_have_the_sections_of_the_anatomy_in_order(page):
    headings = re.findall(r"^## (.+)$", read(page), re.MULTILINE)
    fixed = [
        "Question and objectives",
        "Where we are",
        "Set up",
        "Expected result",
        "Check your understanding",
        "Exercises",
        "Common errors",
        "Recap",
        "New words",
        "Further reading",
    ]
    assert [h for h in headings if h in fixed] == fixed
    ideas = [h for h in headings if h not in fixed]
    assert 1 <= len(ideas) <= 3


@pytest.mark.parametrize("page", STEPS, ids=str)
def test_every_step_has_its_exercise_page_and_leads_to_it(page):
    assert Path("exercises", page.name) in EXERCISES
    _, _, tail = read(page).partition("\n## Exercises\n")
    section, _, _ = tail.partition("\n## ")
    cards = [one for one in load_exercises().values() if one.chapter == page.name]
    assert cards
    assert f"(../exercises/{page.name}.md)" in section
    for card in cards:
        points = "" if card.is_challenge else f" ({card.points} points)"
        assert f"`{card.name} <exercise-{card.name.replace('_', '-')}>`{points}" in section


@pytest.mark.parametrize("page", EXERCISES, ids=str)
def test_exercise_pages_state_start_check_and_hint_each_exercise(page):
    text = read(page)
    cards = [one for one in load_exercises().values() if one.chapter == page.name]
    assert cards
    for card in cards:
        label = f"(exercise-{card.name.replace('_', '-')})=\n## "
        _, _, tail = text.partition(label)
        section, _, _ = tail.partition("\n(exercise-")
        starter = (ROOT / "exercises/_generated" / f"{card.name}.py").read_text(encoding="utf-8")
        code = starter.split('"""\n\n', 1)[1].strip()
        assert f":tags: [exercise]\n{code}\n```" in section
        assert f'\ncheck("{card.name}", {card.name})\n' in section
        assert f'hint("{card.name}")' in section
        statement, _, _ = section.partition("<!-- begin exercise")
        assert len(statement.split()) > 40
        assert f"{card.name}(" in statement  # an example call
        for hint in card.hints:
            assert hint not in text  # hints are asked for, and counted
    assert text.count(":tags: [exercise]") == len(cards)


@pytest.mark.parametrize("page", STEPS, ids=str)
def test_steps_ask_before_they_show_and_check_against_the_truth(page):
    text = read(page)
    for box in ("predict", "check", "pitfall", "tryit"):
        assert re.search(rf"^:class: {box}$", text, re.MULTILINE), box
    assert "nbval-check-output" in text


@pytest.mark.parametrize("page", PAGES, ids=str)
def test_pages_and_their_cells_stay_short(page):
    # Starters are written by a tool, and an explorer comes with its question, its task and a cell
    # that uses it. Front matter, alt texts and captions do not count either:
    # nobody should save on those.
    text = re.sub(STARTER, "", read(page), flags=re.DOTALL | re.MULTILINE)
    seen = re.sub(r"^---\n.*?^---\n", "", text, flags=re.DOTALL | re.MULTILINE)
    assert len(seen.splitlines()) <= 350 + 40 * text.count("\nfrom labutils.explorers import ")
    for cell in re.findall(r"^```\{code-cell\}.*?\n(.*?)^```$", text, re.DOTALL | re.MULTILINE):
        code = re.sub(r"\A---\n.*?^---\n", "", cell, flags=re.DOTALL | re.MULTILINE)
        lines = [
            line for line in code.splitlines() if line.strip() and not line.startswith((":", "#"))
        ]
        assert len(lines) <= 8, cell


@pytest.mark.parametrize("page", PAGES, ids=str)
def test_pages_import_nothing_but_the_library_and_what_it_teaches(page):
    allowed = {"labutils", "numpy", "cv2", "mujoco", "open3d"}
    text = re.sub(r'""".*?"""', "", read(page), flags=re.DOTALL)  # docstrings of the starters
    for cell in re.findall(r"^```\{code-cell\}.*?^```$", text, re.DOTALL | re.MULTILINE):
        for name in re.findall(r"^\s*(?:from|import) (\w+)", cell, re.MULTILINE):
            standard = name in {
                "pathlib",
                "tempfile",
                "time",
                "sys",
                "os",
                "subprocess",
                "warnings",
            }
            assert name in allowed or standard, name


def test_the_rules_for_pages_find_what_they_look_for():
    # or a change of the markup would make the tests above pass by finding nothing
    text = "\n".join(read(page) for page in PAGES)
    for pattern in (
        r"^[`:]{3,}\{(?:figure|image)\}.*?^[`:]{3,}$",
        r"^```\{code-cell\}.*?^```$",
        STARTER,
        r"^(?:figures\.)?(?:plot_|visualize_pointcloud)",
        r"^\s*(?:from|import) \w+",
        r"^:alt: [^\n]{20,}",
    ):
        assert len(re.findall(pattern, text, re.DOTALL | re.MULTILINE)) > 5, pattern
