"""Pack the widgets for Python in the page: ipywidgets, anywidget, what they need, the explorers.

They come from the installed packages, as do their licenses, so that both ends always agree. Only
Python is taken: JavaScript comes with the page (``frontend.py``), compiled modules fit no browser.

``tools/vendor/pack_python.py`` makes of them a part that pages load with the first cell that
imports widgets.
"""

from __future__ import annotations

import re
from importlib.metadata import Distribution, PackageNotFoundError, distribution
from typing import TYPE_CHECKING

from tools import ROOT
from tools.stable_zip import make_zip
from tools.vendor.npm import VendorError

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

ASSET = "widgets.zip"
PACKAGES = ("anywidget", "comm", "ipywidgets", "psygnal", "traitlets", "typing_extensions")
EXPLORERS = ROOT / "labutils" / "explorers"

#: Of the packages, what no widget needs: tests, commands of IPython, settings of applications.
DROPPED = re.compile(
    r"/tests/|/testing|/_pyinstaller_util/|^psygnal/(?:containers/|qt|_evented_model)"
    r"|^traitlets/config/(?:application|argcomplete_config|loader|manager|sphinxdoc)"
    r"|^tqdm/(?:contrib/|dask|keras|notebook|rich|tk)"
    r"|^ipywidgets/embed\.py|^anywidget/_cellmagic"
)
LICENSE = re.compile(r"\.dist-info/.*licen[cs]e[^/]*$", re.IGNORECASE)


def make_widget_assets() -> dict[str, bytes]:
    """Return the archive that Python in the page unpacks beside its packages, by its name.

    Raises
    ------
    tools.vendor.npm.VendorError
        If a package is not installed.
    """
    return {ASSET: make_zip(sorted(_collect()))}


def read_widget_licenses() -> str:
    """Join the license texts of the packages.

    Raises
    ------
    tools.vendor.npm.VendorError
        If a package is not installed, or brings none.
    """
    return "\n".join(map(read_license, PACKAGES))


def list_widget_sources() -> list[Path]:
    """List our own files among the contents, for who has to know whether they changed."""
    return _list_explorers()


def _collect() -> Iterator[tuple[str, bytes]]:
    for name in PACKAGES:
        yield from collect_package(name)
    for path in _list_explorers():
        yield path.relative_to(ROOT).as_posix(), path.read_bytes()


def _list_explorers() -> list[Path]:
    return [
        *sorted(EXPLORERS.glob("*.py")),
        *sorted(path for ending in ("js", "css") for path in EXPLORERS.glob(f"static/*.{ending}")),
    ]


def collect_package(name: str) -> Iterator[tuple[str, bytes]]:
    """Find what Python in the page needs of an installed package: its modules, and its version."""
    package = _find(name)
    for file in package.files or ():
        place = file.as_posix()
        if place.endswith(".py") and not place.startswith("..") and not DROPPED.search(place):
            yield place, file.read_binary()
    # packages ask for their own version
    title, version = package.metadata["Name"], package.version
    head = f"Metadata-Version: 2.1\nName: {title}\nVersion: {version}\n"
    yield f"{title}-{version}.dist-info/METADATA", head.encode()


def _find(name: str) -> Distribution:
    try:
        return distribution(name)
    except PackageNotFoundError:
        raise VendorError(f"{name} is missing: pip install -r requirements.txt") from None


def read_license(name: str) -> str:
    """Return the license text of an installed package, under its name."""
    package = _find(name)
    texts = [file.read_text() for file in package.files or () if LICENSE.search(file.as_posix())]
    if not texts:
        raise VendorError(f"{package.metadata['Name']} brings no license")
    title = f"{package.metadata['Name']} {package.version}"
    return f"{title}\n{'=' * len(title)}\n" + "\n".join(text.strip() for text in texts) + "\n"
