"""Nothing is written that nobody can find: pages, widgets, images, objectives."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from content.chapters import OBJECTIVES, Chapter, list_taught
from solutions import load_exercises
from tests.helpers.chapters import ROOT, find_orphans, find_pages, get_toc_pages

CHAPTERS = list_taught()
EXERCISES = [page for page in get_toc_pages() if page.parts[0] == "exercises"]
STARTER = r"^```\{code-cell\}[^\n]*\n:tags: \[exercise(?:, completion)?\]\n.*?^```$"
PAGES = find_pages()
NO_ALT = "expected an alt text of 20 characters and more that says the finding"
FRONT_MATTER = r"^---\n.*?^---\n"
DRAWING = r"^```\{figure\}.*?^```$\n*"
FOLDED = r"^### For the curious.*?(?=^##|^\([\w-]+\)=$)"  # "# " begins a comment in a cell
MAX_LINES, MAX_CELL = 400, 8


def read(page: Path | str) -> str:
    """The text of a page."""
    return (ROOT / page).with_suffix(".md").read_text(encoding="utf-8")


def test_every_page_and_widget_can_be_reached() -> None:
    assert find_orphans() == []


def test_an_orphan_of_every_kind_is_noticed(tmp_path: Path) -> None:
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
def test_every_picture_says_its_finding_in_words(page: Path) -> None:
    text = read(page)
    figures = re.findall(
        r"^[`:]{3,}\{(?:figure|image)\}.*?^[`:]{3,}$", text, re.DOTALL | re.MULTILINE
    )
    for figure in figures:
        assert re.search(r"^:alt: [^\n]{20,}", figure, re.MULTILINE), f"{NO_ALT}: {figure}"
    for cell in re.findall(r"^```\{code-cell\}.*?^```$", text, re.DOTALL | re.MULTILINE):
        last = [line for line in cell.splitlines() if line.strip()][-2]
        if re.match(r"((figures|lab)\.)?(plot_|visualize_pointcloud)", last):
            assert re.search(r"alt: .{20,}", cell), f"{NO_ALT}: {cell}"
    assert not re.search(r"!\[\]\(", text), "an image without words"


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda one: one.id)
def test_the_recap_answers_the_objectives_one_by_one(chapter: Chapter) -> None:
    head, _, tail = read(chapter.page).partition("## Recap")
    pattern = rf"^- \*\*({chapter.prefix}[a-e])\.\*\* "
    objectives = re.findall(pattern, head, re.MULTILINE)
    due = OBJECTIVES[chapter.kind]
    assert len(objectives) in due, f"expected {due[0]} to {due[-1]} objectives, got {objectives}"
    answered = re.findall(pattern, tail, re.MULTILINE)
    assert answered == objectives, "expected the objectives again in the recap, in their order"


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda one: one.id)
def test_chapters_have_the_sections_of_the_anatomy_in_order(chapter: Chapter) -> None:
    headings = re.findall(r"^## (.+)$", read(chapter.page), re.MULTILINE)
    has_points = any(one.points for one in load_exercises().values() if one.chapter == chapter.id)
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
    if has_points or "Worked examples" in headings:  # without points a chapter may have some
        fixed.insert(fixed.index("Exercises"), "Worked examples")
    found = [h for h in headings if h in fixed]
    assert found == fixed, f"expected the sections {fixed}, in this order, got {found}"
    ideas = [h for h in headings if h not in fixed]
    assert 1 <= len(ideas) <= 3, f"expected 1 to 3 sections of its own, one per idea, got {ideas}"


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda one: one.id)
def test_every_exercise_with_points_has_a_worked_example_of_its_own(chapter: Chapter) -> None:
    _, _, tail = read(chapter.page).partition("\n## Worked examples\n")
    section, _, _ = tail.partition("\n## ")
    due = [
        card.completion.section if card.completion else f"a completion of {card.name}"
        for card in load_exercises().values()
        if card.chapter == chapter.id and card.points
    ]
    found = re.findall(r"^\((.+)\)=\n### ", section, re.MULTILINE)
    assert found == (due or [one for one in found if one.startswith(f"{chapter.id}-worked-")])
    for example in re.split(r"^\(.+\)=\n", section, flags=re.MULTILINE)[1:]:
        cells = example.count("```{code-cell}")
        assert 1 <= cells <= 3, f"expected one to three cells, got {cells}: {example[:60]}"
        assert "nbval-check-output" in example or "mystnb" in example, example[:60]


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda one: one.id)
def test_every_chapter_has_its_exercise_page_and_leads_to_it(chapter: Chapter) -> None:
    assert Path(chapter.exercises) in EXERCISES
    _, _, tail = read(chapter.page).partition("\n## Exercises\n")
    section, _, _ = tail.partition("\n## ")
    cards = [one for one in load_exercises().values() if one.chapter == chapter.id]
    assert cards, f"expected at least one exercise of {chapter.id}"
    assert f"(../{chapter.exercises}.md)" in section
    for card in cards:
        points = f" ({card.points} points)" if card.points else ""
        assert f"`{card.name} <exercise-{card.name.replace('_', '-')}>`{points}" in section


def test_every_exercise_page_belongs_to_a_chapter() -> None:
    assert [page.as_posix() for page in EXERCISES] == [one.exercises for one in CHAPTERS]


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda one: one.id)
def test_exercise_pages_state_start_check_and_hint_each_exercise(chapter: Chapter) -> None:
    text = read(chapter.exercises)
    cards = [one for one in load_exercises().values() if one.chapter == chapter.id]
    assert cards, chapter.id
    for card in cards:
        label = f"(exercise-{card.name.replace('_', '-')})=\n### "
        _, _, tail = text.partition(label)
        section, _, _ = tail.partition("\n(exercise-")
        starter = (ROOT / "exercises/_generated" / f"{card.name}.py").read_text(encoding="utf-8")
        code = starter.split('"""\n\n', 1)[1].strip()
        assert f":tags: [exercise]\n{code}\n```" in section
        assert f'\ncheck("{card.name}", {card.name})\n' in section
        assert f'hint("{card.name}")' in section
        statement, _, _ = section.partition("<!-- begin exercise")
        words = len(statement.split())
        assert words > 40, f"{card.name}: expected a statement of more than 40 words, got {words}"
        # what acts in a loop is handed to the loop, which calls it
        assert re.search(rf"\b{card.name}\(|\({card.name},", statement), (
            f"{card.name}: expected an example call"
        )
        for hint in card.hints:
            assert hint not in text, "a hint stands on the page: hints are asked for, and counted"
    assert text.count(":tags: [exercise]") == len(cards), "expected one starter for each card"


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda one: one.id)
def test_chapters_ask_before_they_show_and_check_against_the_truth(chapter: Chapter) -> None:
    text = read(chapter.page)
    for box in ("predict", "check", "pitfall", "tryit"):
        found = re.search(rf"^:class: {box}$", text, re.MULTILINE)
        assert found, f"expected at least one box of the class {box}"
    assert "nbval-check-output" in text, "expected a cell whose output is compared"


@pytest.mark.parametrize("page", PAGES, ids=str)
def test_pages_and_their_cells_stay_short(page: Path) -> None:
    # Starters are written by a tool, and an explorer comes with its question, its task and a cell
    # that uses it, a worked example with its cells. Front matter, alt texts, captions and drawings
    # do not count either: nobody should save on those. Nor does what is folded away: who does not
    # open it does not read it.
    text = re.sub(STARTER, "", read(page), flags=re.DOTALL | re.MULTILINE)
    seen = text
    for uncounted in (FRONT_MATTER, DRAWING, FOLDED):
        seen = re.sub(uncounted, "", seen, flags=re.DOTALL | re.MULTILINE)
    count = len(seen.splitlines())
    limit = MAX_LINES + 40 * text.count("\nfrom labutils.explorers import ")
    limit += 35 * len(re.findall(r"^\([a-z]+\d?-worked", text, re.MULTILINE))
    assert count <= limit, f"expected a page of at most {limit} lines, got {count}"
    for cell in re.findall(r"^```\{code-cell\}.*?\n(.*?)^```$", text, re.DOTALL | re.MULTILINE):
        code = re.sub(r"\A---\n.*?^---\n", "", cell, flags=re.DOTALL | re.MULTILINE)
        lines = [
            line for line in code.splitlines() if line.strip() and not line.startswith((":", "#"))
        ]
        assert len(lines) <= MAX_CELL, f"expected a cell of at most {MAX_CELL} lines: {cell}"


@pytest.mark.parametrize("page", PAGES, ids=str)
def test_pages_import_nothing_but_the_library_and_what_it_teaches(page: Path) -> None:
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
            assert name in allowed or standard, f"cells may not import {name}"


def test_the_rules_for_pages_find_what_they_look_for() -> None:
    # or a change of the markup would make the tests above pass by finding nothing
    text = "\n".join(read(page) for page in PAGES)
    for pattern in (
        r"^[`:]{3,}\{(?:figure|image)\}.*?^[`:]{3,}$",
        r"^```\{code-cell\}.*?^```$",
        STARTER,
        r"^(?:(?:figures|lab)\.)?(?:plot_|visualize_pointcloud)",
        r"^\s*(?:from|import) \w+",
        r"^:alt: [^\n]{20,}",
    ):
        assert len(re.findall(pattern, text, re.DOTALL | re.MULTILINE)) > 5, pattern
