"""axe-core finds nothing serious on any page, in either theme; as files all open quietly."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from tests.helpers import browser

THEMES = ("light", "dark")


@pytest.fixture(scope="module")
def audits(
    chromium: Callable[..., Any], file_site: str, once: Callable[..., Any]
) -> dict[str, Any]:
    """What axe-core says: {page: {themes: {theme: findings}, complaints}}."""
    return once("axe", lambda: chromium("axe.mjs", file_site, *browser.names_of_pages()))


@pytest.mark.parametrize("theme", THEMES)
@pytest.mark.parametrize("page", browser.names_of_pages())
def test_a_page_has_no_serious_barrier(audits: dict[str, Any], page: str, theme: str) -> None:
    audit = audits[page]["themes"][theme]
    assert audit["theme"] == theme
    said = [f"{finding['rule']}: {finding['places']}" for finding in audit["findings"]]
    assert not said, "\n".join(said)


@pytest.mark.parametrize("page", browser.names_of_pages())
def test_a_page_opens_from_a_file_without_errors(audits: dict[str, Any], page: str) -> None:
    assert audits[page]["complaints"] == []
