"""axe-core finds nothing serious on any page, in either theme."""

from __future__ import annotations

import pytest

from tests.helpers import browser

THEMES = ("light", "dark")


@pytest.fixture(scope="module")
def audits(chromium, file_site, once):
    """What axe-core says: {page: {theme: findings}}."""
    return once("axe", lambda: chromium("axe.mjs", file_site, *browser.names_of_pages()))


@pytest.mark.parametrize("theme", THEMES)
@pytest.mark.parametrize("page", browser.names_of_pages())
def test_a_page_has_no_serious_barrier(audits, page, theme):
    audit = audits[page][theme]
    assert audit["theme"] == theme
    said = [f"{finding['rule']}: {finding['places']}" for finding in audit["findings"]]
    assert not said, "\n".join(said)
