"""The harness itself: it says what is missing, and hides no failure."""

from __future__ import annotations

from collections.abc import Callable
from http.client import HTTPConnection
from pathlib import Path
from typing import NoReturn
from urllib.parse import urlsplit

import pytest
from _pytest.outcomes import Failed, Skipped

from tests.helpers import browser
from tools.vendor import npm


def test_a_browser_named_by_the_environment_comes_first(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CHROMIUM", "/opt/own/chromium")
    assert browser.require_chromium() == "/opt/own/chromium"


@pytest.mark.parametrize(
    ("require", "message"),
    [
        (browser.require_chromium, "no Chromium found; install it or set CHROMIUM"),
        (browser.require_firefox, "no Firefox found; install it or set FIREFOX"),
    ],
)
def test_without_a_browser_tests_are_skipped_or_fail_where_it_is_required(
    require: Callable[[], str], message: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    for name in ("CHROMIUM", "FIREFOX", "REQUIRE_BROWSER"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(Skipped, match=message):
        require()
    monkeypatch.setenv("REQUIRE_BROWSER", "1")
    with pytest.raises(Failed, match=message):
        require()


def test_without_pages_the_command_that_builds_them_is_named(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.delenv("REQUIRE_BROWSER", raising=False)
    monkeypatch.setattr(browser, "STUDENT_PAGES", tmp_path)
    with pytest.raises(Skipped, match="make book"):
        browser.require_pages()


def test_without_a_network_the_missing_drivers_are_named(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse() -> NoReturn:
        raise npm.VendorError("npm could not fetch")

    monkeypatch.delenv("REQUIRE_BROWSER", raising=False)
    monkeypatch.setattr(npm, "install", refuse)
    with pytest.raises(Skipped, match="npm could not fetch"):
        browser.require_packages()


def test_a_script_that_fails_shows_its_reason(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(browser, "SCRIPTS", tmp_path)
    (tmp_path / "broken.mjs").write_text('throw new Error("the tab is gone");')
    with pytest.raises(AssertionError, match="the tab is gone"):
        browser.run_script("broken.mjs")


def test_a_script_gets_its_arguments_and_returns_its_json(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(browser, "SCRIPTS", tmp_path)
    (tmp_path / "echo.mjs").write_text(
        "process.stdout.write(JSON.stringify([...process.argv.slice(2), process.env.FROM_TEST]));"
    )
    answer = browser.run_script("echo.mjs", "a b", 3, variables={"FROM_TEST": "yes"})
    assert answer == ["a b", "3", "yes"]


def test_what_is_made_once_is_read_afterwards(tmp_path: Path) -> None:
    made = []

    def make() -> dict[str, int]:
        made.append(1)
        return {"page": 1}

    path = tmp_path / "once.json"
    assert browser.once(path, make) == browser.once(path, make) == {"page": 1}
    assert len(made) == 1


def test_a_folder_is_served_while_it_is_needed(tmp_path: Path) -> None:
    (tmp_path / "page.html").write_text("text")
    with browser.serve(tmp_path) as address:
        server = HTTPConnection(urlsplit(address).netloc)
        server.request("GET", "/page.html")
        assert server.getresponse().read() == b"text"
        server.close()
    with pytest.raises(ConnectionError):
        server.request("GET", "/page.html")
