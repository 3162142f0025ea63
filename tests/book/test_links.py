"""The links of the built pages lead somewhere; the checker finds those that do not."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, HTTPServer
from pathlib import Path

import pytest

from tests.helpers import browser
from tools.build.links import find_broken, find_broken_outside, read_links


def test_every_link_inside_the_book_leads_somewhere() -> None:
    pages = browser.require_pages()
    assert len(read_links(pages)) > 500  # or nothing was read
    assert find_broken(pages) == []


@pytest.fixture
def site(tmp_path: Path) -> Path:
    (tmp_path / "deep").mkdir()
    (tmp_path / "picture.png").touch()
    (tmp_path / "deep" / "other.html").write_text('<h2 id="a b">Here</h2>')
    return tmp_path


@pytest.mark.parametrize(
    ("link", "fault"),
    [
        ('<a href="deep/other.html#a%20b">', ""),
        ('<img src="picture.png">', ""),
        ('<a href="#own"></a><b id="own">', ""),
        ('<a href="mailto:someone@example.org">', ""),
        ('<a href="https://example.org/none">', ""),  # of others: not asked here
        ('<a href="deep/none.html">', "no file for deep/none.html"),
        ('<img src="none.png">', "no file for none.png"),
        ('<a href="deep/other.html#c">', "no such place: deep/other.html#c"),
        ('<a href="#none">', "no such place: #none"),
    ],
)
def test_a_link_that_leads_nowhere_is_named(site: Path, link: str, fault: str) -> None:
    (site / "page.html").write_text(link)
    assert find_broken(site) == ([f"page.html: {fault}"] if fault else [])


class Answers(BaseHTTPRequestHandler):
    """A server that knows one page, and lets no program read another."""

    def do_GET(self) -> None:
        self.send_response({"/here": 200, "/people-only": 403}.get(self.path, 404))
        self.end_headers()

    def log_message(self, *_: object) -> None:
        """Stay quiet."""


@pytest.fixture
def others() -> Iterator[str]:
    server = HTTPServer(("127.0.0.1", 0), Answers)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    yield f"http://127.0.0.1:{server.server_port}"
    server.shutdown()
    server.server_close()


def test_pages_of_others_are_asked(site: Path, others: str) -> None:
    names = ("here#place", "people-only", "gone")
    (site / "page.html").write_text("".join(f'<a href="{others}/{name}">' for name in names))
    assert find_broken_outside(site) == [f"{others}/gone (page.html): status 404"]
