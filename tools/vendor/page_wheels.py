"""Find NumPy and OpenCV for Python in the page: wheels that no package index offers.

Three sources are tried in turn. A folder, named by the variable ``CAMERA_LAB_WHEELS``, whose files
are verified against its ``SHA256SUMS`` where it has one. Then the official files of Pyodide, with
names and checksums from the lock file that comes with it, kept in ``_build/wheels``. Where neither
can be had, the pages load these official files themselves when they are read. So a build never
fails for lack of wheels.
"""

from __future__ import annotations

import hashlib
import json
import os
import sys
import urllib.request
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

from tools import ROOT

VARIABLE = "CAMERA_LAB_WHEELS"
CACHE = ROOT / "_build" / "wheels"
SUMS = "SHA256SUMS"
CDN = "https://cdn.jsdelivr.net/pyodide/v{version}/full/{file_name}"
SECONDS = 20  # without an answer from the CDN: the build goes on

# name of the asset, name in Pyodide's lock file, and how its wheel may be called in a folder
PACKAGES = (
    ("numpy", "numpy", "numpy-{version}-*.whl"),
    ("cv2", "opencv-python", "opencv_python*-{version}-*.whl"),
)

Download = Callable[[str], bytes]


class WheelError(Exception):
    """A source does not hold what it should; the message says what was expected."""


@dataclass(frozen=True)
class RemoteWheel:
    """A wheel that the page itself has to load."""

    name: str
    url: str
    sha256: str


@dataclass(frozen=True)
class Wheels:
    """What was found: wheels by name of the asset, or where a page finds them."""

    said: str
    files: dict[str, Path] = field(default_factory=dict)
    remote: tuple[RemoteWheel, ...] = ()


def find_wheels(lock_file: Path, version: str, download: Download | None = None) -> Wheels:
    """Take the first source that has both wheels.

    Parameters
    ----------
    lock_file : Path
        Pyodide's own lock file.
    version : str
        Of Pyodide.
    download : callable, optional
        Gets the bytes behind an address, or raises OSError.
    """
    packages = json.loads(lock_file.read_text(encoding="utf-8"))["packages"]
    wanted = {name: packages[locked] for name, locked, _ in PACKAGES}
    if folder := os.environ.get(VARIABLE):
        try:
            return Wheels(f"the folder {VARIABLE} names", find_in_folder(Path(folder), wanted))
        except WheelError as error:
            print(f"python in the page: {VARIABLE}: {error}; trying the CDN", file=sys.stderr)
    remote = tuple(
        RemoteWheel(
            name, CDN.format(version=version, file_name=entry["file_name"]), entry["sha256"]
        )
        for name, entry in wanted.items()
    )
    try:
        files = {wheel.name: fetch(wheel, download or _download) for wheel in remote}
    except WheelError as error:
        said = f"the CDN, when a page is read: its reader needs a network ({error})"
        return Wheels(said, remote=remote)
    return Wheels("the official files", files)


def find_in_folder(folder: Path, wanted: dict[str, dict[str, str]]) -> dict[str, Path]:
    """Find both wheels in a folder, and verify them.

    Raises
    ------
    WheelError
        If one is missing, comes twice, or is not what the checksums say.
    """
    sums = _read_sums(folder / SUMS)
    found = {}
    for name, _, form in PACKAGES:
        pattern = form.format(version=wanted[name]["version"])
        paths = sorted(folder.glob(pattern))
        if len(paths) != 1:
            raise WheelError(f"expected one file {pattern} in the folder, found {len(paths)}")
        (path,) = paths
        tags = wanted[name]["file_name"].split("-", 2)[2]
        if not path.name.endswith(tags):
            raise WheelError(f"expected a wheel for {tags}, found {path.name}")
        if sums and sums.get(path.name) != _get_sha256(path.read_bytes()):
            expected = sums.get(path.name, "no line for it")
            raise WheelError(f"{path.name} is not what {SUMS} says (expected {expected})")
        found[name] = path
    return found


def fetch(wheel: RemoteWheel, download: Download) -> Path:
    """Return an official file, from the cache or downloaded; verified either way.

    Raises
    ------
    WheelError
        If it cannot be downloaded, or is another file than the lock file means.
    """
    path = CACHE / wheel.url.rpartition("/")[2]
    if path.is_file() and _get_sha256(path.read_bytes()) == wheel.sha256:
        return path
    try:
        content = download(wheel.url)
    except OSError as error:
        raise WheelError(f"no download: {getattr(error, 'reason', error)}") from error
    if _get_sha256(content) != wheel.sha256:
        raise WheelError(f"{path.name} does not have the checksum of Pyodide's lock file")
    CACHE.mkdir(parents=True, exist_ok=True)
    unfinished = path.with_suffix(".part")
    unfinished.write_bytes(content)
    unfinished.rename(path)
    return path


def _download(url: str) -> bytes:
    # only the address above, which begins with https
    with urllib.request.urlopen(url, timeout=SECONDS) as answer:  # noqa: S310
        return answer.read()


def _read_sums(path: Path) -> dict[str, str]:
    """Read {file name: checksum}; empty where the folder has no such file."""
    if not path.is_file():
        return {}
    lines = (line.split() for line in path.read_text(encoding="utf-8").splitlines())
    return {parts[1].lstrip("*"): parts[0] for parts in lines if len(parts) == 2}


def _get_sha256(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()
