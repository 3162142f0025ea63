"""The concept questions: complete, explained, and drawn so that everybody can answer them."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from collections import Counter
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import pytest
import yaml

from content.quiz_items import CONCEPTS, Item, QuizError, load_all, load_page
from tests.helpers.chapters import ROOT

PAGES = load_all()
ITEMS = [item for items in PAGES.values() for item in items]
FACTS = sorted((ROOT / "tests" / "book").glob("test_quiz_facts_*.py"))

GOOD: dict[str, Any] = {
    "id": "x1",
    "section": "a-label",
    "question": "How many?",
    "choices": [
        {"text": str(n), "feedback": f"An explanation of {n} that is long enough to help.", **right}
        for n, right in enumerate(({"right": True}, {}, {}))
    ],
}


def write(folder: Path, *entries: dict[str, Any] | str) -> None:
    """Write a file of questions for a page that is called page."""
    (folder / "page.yml").write_text(yaml.safe_dump(list(entries)), encoding="utf-8")


# ---- What is asked


def test_every_chapter_with_questions_shows_its_own() -> None:
    assert PAGES
    for page in PAGES:
        text = (ROOT / "book" / f"{page}.md").read_text(encoding="utf-8")
        assert re.findall(r"^```\{quiz\} (.+)$", text, re.MULTILINE) == [page]
        assert "\n## Check your understanding\n" in text


@pytest.mark.parametrize("item", ITEMS, ids=lambda item: item.id)
def test_feedback_explains_and_does_not_only_judge(item: Item) -> None:
    for choice in item.choices:
        judges = re.match(r"(wrong|right|no|yes|correct|incorrect)\b", choice.feedback.lower())
        assert not judges, f"expected an explanation first, got {choice.feedback!r}"
        ends = choice.feedback.endswith((".", "?", "!"))
        assert ends, f"expected sentences, got {choice.feedback!r}"


def find_longest(item: Item) -> int:
    """The place of the longest choice."""
    return max(range(len(item.choices)), key=lambda n: len(item.choices[n].text))


def test_the_place_of_the_right_choice_tells_nothing() -> None:
    places = Counter(item.right_index for item in ITEMS)
    shares = f"places of the right choices: {dict(places)} of {len(ITEMS)}"
    assert max(places.values()) <= 0.4 * len(ITEMS), f"expected no place above 40 %; {shares}"
    longest = [find_longest(item) for item in ITEMS]
    hits = sum(place == item.right_index for place, item in zip(longest, ITEMS, strict=True))
    assert hits <= 0.45 * len(ITEMS), f"the longest choice is right in {hits} of {len(ITEMS)}"


def test_every_computed_answer_has_its_test_and_every_test_its_question() -> None:
    written = {
        name
        for path in FACTS
        for name in re.findall(r"^def (test_\w+)", path.read_text(encoding="utf-8"), re.MULTILINE)
    }
    asked = [item.check for item in ITEMS if item.check]
    assert sorted(asked) == sorted(written)


# ---- What is refused


def test_a_good_question_is_read(tmp_path: Path) -> None:
    write(tmp_path, GOOD, GOOD | {"id": "x2", "check": "test_it"})
    first, second = load_page("page", tmp_path)
    assert (first.right_index, first.right_text, first.objective) == (0, "0", None)
    assert (second.page, second.check) == ("page", "test_it")


def change_choice(place: int, **fields: Any) -> dict[str, Any]:
    """The good question with one choice changed."""
    choices = [dict(choice) for choice in GOOD["choices"]]
    choices[place] |= fields
    return GOOD | {"choices": choices}


@pytest.mark.parametrize(
    ("entry", "message"),
    [
        ("text", "question 1: expected fields with names, got 'text'"),
        (GOOD | {"id": "x-long"}, "id: expected letters and digits such as 2a, got 'x-long'"),
        (GOOD | {"id": 12}, "id: expected str, got 12; write it in quotes"),
        (GOOD | {"hint": "?"}, "unknown field hint; known are id, section"),
        (GOOD | {"question": " "}, "question: is empty"),
        ({k: v for k, v in GOOD.items() if k != "section"}, "the field section is missing"),
        (GOOD | {"choices": GOOD["choices"][:2]}, "x1: expected 3 or 4 choices, got 2"),
        (change_choice(1, right=True), "x1: expected one choice with right: true, got 2"),
        (change_choice(0, right=False), "x1: expected one choice with right: true, got 0"),
        (change_choice(1, text="0"), "x1: two choices have the same text"),
        (
            change_choice(1, feedback=GOOD["choices"][0]["feedback"]),
            "x1: two choices have the same feedback",
        ),
        (
            change_choice(2, feedback="Wrong."),
            "x1, choice 3: feedback: expected at least 40 characters that explain, got 'Wrong.'",
        ),
        (change_choice(2, text=5), "choice 3: text: expected str, got 5; write it in quotes"),
    ],
)
def test_a_bad_question_is_refused_with_the_place(
    entry: str | dict[str, Any], message: str, tmp_path: Path
) -> None:
    write(tmp_path, entry, GOOD | {"id": "x9"})
    with pytest.raises(QuizError, match=re.escape(message)) as refusal:
        load_page("page", tmp_path)
    assert str(refusal.value).startswith("page.yml, ")


def test_a_file_that_is_no_list_of_questions_is_refused(tmp_path: Path) -> None:
    write(tmp_path, GOOD)
    with pytest.raises(QuizError, match=r"page\.yml: expected a list of 2 to 5 questions"):
        load_page("page", tmp_path)
    (tmp_path / "page.yml").write_text("- [", encoding="utf-8")
    with pytest.raises(QuizError, match=r"page\.yml: not YAML"):
        load_page("page", tmp_path)


def test_an_unknown_page_lists_the_known_ones(tmp_path: Path) -> None:
    write(tmp_path, GOOD, GOOD)
    with pytest.raises(QuizError, match=r"other: no questions for this page; .* for: page"):
        load_page("other", tmp_path)


def test_an_id_is_given_once(tmp_path: Path) -> None:
    write(tmp_path, GOOD, GOOD)
    with pytest.raises(QuizError, match=r"page\.yml, x1: this id is taken in page\.yml"):
        load_all(tmp_path)


# ---- What the reader gets


class Outline(HTMLParser):
    """The elements of a page with their attributes, and the names of their ancestors."""

    def __init__(self, html: str) -> None:
        super().__init__()
        self.found: list[tuple[str, dict[str, Any], tuple[str, ...]]] = []
        self.open: list[str] = []
        self.feed(html)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.found.append((tag, dict(attrs), tuple(self.open)))
        if tag not in {"input", "meta", "link", "br", "hr", "img"}:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        while self.open and self.open.pop() != tag:
            pass

    def get(self, tag: str, class_: str | None = None) -> list[dict[str, Any]]:
        """List the attributes of the elements of one kind."""
        return [a for t, a, _ in self.found if t == tag and class_ in (None, a.get("class"))]


def build(folder: Path, text: str) -> subprocess.CompletedProcess[str]:
    """Build a book of one page with nothing but the directive."""
    (folder / "index.md").write_text(text, encoding="utf-8")
    paths = (str(ROOT / "book" / "_ext"), *filter(None, [os.environ.get("PYTHONPATH")]))
    command = [sys.executable, "-m", "sphinx", "-C", "-n", "-W", "-q", "-b", "html"]
    command += ["-D", "extensions=myst_parser,quiz", "-D", "language=en", ".", "out"]
    return subprocess.run(
        command,
        cwd=folder,
        env=os.environ | {"PYTHONPATH": os.pathsep.join(paths)},
        capture_output=True,
        text=True,
        check=False,
    )


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> str:
    """The questions of step 2, drawn."""
    folder = tmp_path_factory.mktemp("quiz")
    labels = {item.section for item in PAGES["step2_intrinsics"]}
    text = "# Page\n\nSee {ref}`quiz-2a`.\n\n```{quiz} step2_intrinsics\nBody.\n```\n"
    text += "".join(f"\n({label})=\n## About {label}\n" for label in sorted(labels))
    done = build(folder, text)
    assert done.returncode == 0, done.stderr
    return (folder / "out" / "index.html").read_text(encoding="utf-8")


def test_questions_are_groups_of_radio_buttons_with_a_legend(page: str) -> None:
    outline, items = Outline(page), PAGES["step2_intrinsics"]
    assert len(outline.get("fieldset")) == len(outline.get("legend")) == len(items)
    fields = [field for field in outline.get("input") if "quiz" in field.get("name", "")]
    assert {field["type"] for field in fields} == {"radio"}
    expected = [(f"quiz-{i.id}", str(n)) for i in items for n in range(len(i.choices))]
    assert [(field["name"], field["value"]) for field in fields] == expected
    parents = {parents[-2:] for tag, a, parents in outline.found if tag == "input" and a in fields}
    assert parents == {("fieldset", "label")}


def test_feedback_is_announced_and_unfolds_without_a_script(page: str) -> None:
    outline, items = Outline(page), PAGES["step2_intrinsics"]
    assert [div["aria-live"] for div in outline.get("div", "quiz-feedback")] == ["polite"] * 5
    assert all("hidden" in button for button in outline.get("button") if "type" in button)
    assert not any("hidden" in details for details in outline.get("details"))
    for item in items:
        for choice in item.choices:
            assert choice.feedback.split("`")[0].split("*")[0][:30] in page
    links = re.findall(
        r'Read again: <a class="[^"]*" href="#([\w-]+)"><span[^>]*>(.+?)</span>', page
    )
    assert links == [(item.section, f"About {item.section}") for item in items]


def test_the_page_says_which_choice_is_right_and_pages_can_link_to_it(page: str) -> None:
    forms = Outline(page).get("form", "quiz-item")
    expected = [(f"quiz-{i.id}", str(i.right_index)) for i in PAGES["step2_intrinsics"]]
    assert [(form["id"], form["data-right"]) for form in forms] == expected
    assert re.search(r'href="#quiz-2a"><span[^>]*>question 2a</span>', page)
    assert "Body." not in page


def test_a_page_without_questions_fails_the_build(tmp_path: Path) -> None:
    done = build(tmp_path, "# Page\n\n```{quiz} nowhere\n```\n")
    assert done.returncode != 0
    assert "nowhere: no questions for this page" in done.stderr
    assert all(path.stem in done.stderr for path in CONCEPTS.glob("*.yml"))
