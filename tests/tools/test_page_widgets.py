"""What the pages load for widgets: small, Python only, all the explorers, with licenses."""

from __future__ import annotations

import gzip
import io
import zipfile
from pathlib import Path

import pytest

from tools.vendor import page_widgets
from tools.vendor.npm import VendorError

#: Bytes, gzipped. A page loads it only with a cell that imports widgets.
BUDGET = 400_000


def list_members() -> list[str]:
    (content,) = page_widgets.make_widget_assets().values()
    return zipfile.ZipFile(io.BytesIO(content)).namelist()


def test_the_archive_is_the_same_every_time_and_small() -> None:
    (content,) = page_widgets.make_widget_assets().values()
    assert page_widgets.make_widget_assets() == {page_widgets.ASSET: content}
    assert len(gzip.compress(content, 9, mtime=0)) < BUDGET


def test_it_holds_the_packages_and_the_explorers_and_no_compiled_code() -> None:
    members = list_members()
    for name in (
        "anywidget/widget.py",
        "ipywidgets/widgets/widget_output.py",
        "labutils/explorers/static/hsv.js",
        "labutils/explorers/hsv.py",
        "traitlets/traitlets.py",
        "typing_extensions.py",
    ):
        assert name in members
    assert {Path(name).suffix for name in members if Path(name).name != "METADATA"} == {
        ".py",
        ".js",
        ".css",
    }
    assert not [name for name in members if "/tests/" in name or name.startswith(("/", ".."))]


def test_our_own_files_are_listed_for_who_asks_whether_they_changed() -> None:
    ours = {path.name for path in page_widgets.list_widget_sources()}
    assert {"hsv.py", "_frame.js", "hsv.css"} <= ours


def test_every_package_brings_its_license() -> None:
    text = page_widgets.read_widget_licenses()
    for name in page_widgets.PACKAGES:
        assert f"\n{name} " in f"\n{text}"
    assert "Redistribution and use" in text


def test_a_package_that_is_missing_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(page_widgets, "PACKAGES", ("no-such-package",))
    with pytest.raises(VendorError, match="no-such-package is missing: pip install -r"):
        page_widgets.make_widget_assets()
