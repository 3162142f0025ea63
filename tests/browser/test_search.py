"""The search, as a file and from a server: order, excerpts, marks, keyboard, what is said."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from tests.helpers import browser


@pytest.fixture(scope="module", params=browser.PROTOCOLS)
def used(
    request: pytest.FixtureRequest, chromium: Callable[..., Any], once: Callable[..., Any]
) -> dict[str, Any]:
    """What happened when a reader searched."""
    site = request.getfixturevalue(f"{request.param}_site")
    return once(f"search-{request.param}", lambda: chromium("search.mjs", site))


@pytest.mark.parametrize(
    ("query", "page", "place"),
    [
        ("intrinsic", "book/step2_intrinsics", 1),
        ("hue", "book/step4_color", 1),
        ("how do I convert depth to meters", "book/step3_depth", 3),
        ("disparty", "book/glossary", 2),
    ],
)
def test_the_page_that_a_reader_wants_comes_first(
    used: dict[str, Any], query: str, page: str, place: int
) -> None:
    pages = [link.split(".html")[0] for link in used["answers"]["found"][query]["pages"]]
    assert page in pages[:place]


def test_results_have_excerpts_in_which_the_words_are_marked(used: dict[str, Any]) -> None:
    found = used["answers"]["found"]["how do I convert depth to meters"]
    assert found["excerpts"] > 3
    assert {"convert", "depth", "meters"} <= {word.lower() for word in found["marked"]}
    assert "to" not in found["marked"]


def test_the_count_is_said_once_for_each_query(used: dict[str, Any]) -> None:
    answers = used["answers"]
    assert answers["isLive"]
    for query, found in answers["found"].items():
        assert len(found["said"]) == 1, query
    assert "found for “hue”" in answers["found"]["hue"]["said"][0]


def test_a_word_that_the_book_does_not_have_is_named_with_the_nearest(
    used: dict[str, Any],
) -> None:
    found = used["answers"]["found"]
    assert "“disparty” is not in the book, “disparity” is." in found["disparty"]["said"][0]
    assert found["xylophonist"]["pages"] == []
    assert found["xylophonist"]["said"][0].startswith("Nothing found for “xylophonist”")


def test_the_rest_of_many_results_is_shown_on_demand_and_gets_the_focus(
    used: dict[str, Any],
) -> None:
    more = used["answers"]["more"]
    assert 0 < more["some"] < more["all"]
    assert more["next"]


def test_searching_complains_of_nothing_and_starts_in_the_field(used: dict[str, Any]) -> None:
    assert used["answers"]["complaints"] == []
    assert used["answers"]["focused"]
    assert used["fromPage"]["complaints"] == []


def test_the_icon_in_the_field_covers_no_letter(used: dict[str, Any]) -> None:
    assert used["fromPage"]["covered"] <= 0


def test_the_keyboard_leads_from_any_page_to_a_result_and_back(used: dict[str, Any]) -> None:
    assert "book/step4_color.html?highlight=" in used["fromPage"]["link"]
    assert used["fromPage"]["back"] == "hue"


def test_the_words_are_marked_on_the_page_until_escape_is_pressed(used: dict[str, Any]) -> None:
    visit = used["fromPage"]
    assert len(visit["marked"]) > 5
    assert {word.lower() for word in visit["marked"]} <= {"hue", "hues"}
    assert visit["outside"] == 0
    assert visit["left"] == 0
    assert visit["isSame"]


def test_results_on_a_phone_fit_and_are_accessible_in_both_themes(used: dict[str, Any]) -> None:
    assert used["phone"]["tooWide"] <= 0
    assert used["phone"]["themes"] == {"light": [], "dark": []}


def test_without_scripts_a_reader_is_told_what_is_missing(used: dict[str, Any]) -> None:
    assert "activate JavaScript" in used["scriptless"]
