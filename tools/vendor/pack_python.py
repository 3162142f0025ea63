"""Pack Python for the pages: the interpreter, NumPy, OpenCV, the library, the simulator, widgets.

A page that is opened from a file may load scripts but nothing else. So every asset becomes one or
more scripts that hand over a piece of it, gzipped and in base64: ``cameraLabAsset(name, piece,
text)``. Assets come in parts, which the pages load on the first click that needs them; a check
table comes with its exercise.

Everything goes to ``_build/page_python``, which ``book/_ext/exercise_cells.py`` serves; what the
pages have to know of it stands in ``_build/page_python.json``. The same input gives the same bytes.

Usage: ``python -m tools.vendor.pack_python``; ``tools/build/book.py`` runs it before every build.
"""

import base64
import gzip
import hashlib
import json
import re
import shutil
import sys
import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from labutils.checks.table import TABLES, read_completions, read_words
from tools import ROOT
from tools.derive import page_mujoco
from tools.stable_zip import make_zip
from tools.vendor import (
    npm,
    page_python,
    page_recordings,
    page_simulator,
    page_wheels,
    page_widgets,
)
from tools.vendor.npm import VendorError
from tools.vendor.page_optional import find_optional

PACKED = ROOT / "_build" / "page_python"
MANIFEST = ROOT / "_build" / "page_python.json"
FOLDER = "python"  # below the static files of the book
SCRIPTS = ROOT / "book" / "_page_python"
WORKER = "worker.js"
LIBRARY = (
    "labutils/*.py",
    "labutils/_drawing/*.py",
    "labutils/checks/*.py",
    "labutils/checks/*/*.py",
    "labutils/checks/tables/*.json",
    "labutils/renderers/*.py",
)
#: What the library imports besides; in Python alone, so taken as it is installed.
PACKAGES = ("tqdm",)

PIECE = 1 << 20  # bytes: small enough that loading shows progress
# Of the wheels, what no reader's code needs: a third of NumPy.
DROPPED = re.compile(
    r"/tests?/|/include/|/f2py/(?!__init__)|/_pyinstaller/|\.dist-info/|\.pyi$|\.pxd$|\.a$|\.h$"
    r"|_(?:multiarray|umath|operand_flag|rational|struct_ufunc)_tests\."
)
LICENSE = re.compile(r"\.dist-info/.*(?:licen[cs]e|copying)[^/]*$", re.IGNORECASE)

NOTICE = """What runs the code of these pages, and under which license

Pyodide {version}: Mozilla Public License 2.0, https://mozilla.org/MPL/2.0/
    Unchanged; its source is at https://github.com/pyodide/pyodide/tree/{version}
CPython, inside Pyodide: PSF License 2, https://docs.python.org/3/license.html
NumPy and OpenCV: numpy-licenses.txt and cv2-licenses.txt beside this file
tqdm: packages-licenses.txt beside this file
ipywidgets, anywidget and what they need: widgets-licenses.txt beside this file
CodeMirror, the editor: editor-licenses.txt beside this file
"""


def main() -> int:
    """Bring ``_build/page_python`` up to date; return the exit code."""
    version = json.loads((ROOT / "package.json").read_text())["dependencies"]["pyodide"]
    try:
        print(f"python in the page: {page_python.vendor()}", flush=True)
        wheels = page_wheels.find_wheels(page_python.VENDOR / page_python.LOCK, version)
        manifest = pack(wheels, version)
    except VendorError as error:
        print(f"python in the page: {error}", file=sys.stderr)
        return 1
    sizes = (f"{part} {count_bytes(manifest, part) / 1e6:.1f} MB" for part in manifest["parts"])
    print(f"python in the page: NumPy and OpenCV from {wheels.said}; on a click {', '.join(sizes)}")
    return 0


def pack(wheels: page_wheels.Wheels, version: str) -> dict[str, Any]:
    """Write all assets, unless they are there already; return what the pages have to know."""
    wanted = _fingerprint(wheels)
    if MANIFEST.is_file() and PACKED.is_dir():
        manifest = json.loads(MANIFEST.read_text())
        if manifest["version"] == wanted:
            return manifest
    target = PACKED.with_name("page_python.new")
    shutil.rmtree(target, ignore_errors=True)
    folder = target / FOLDER
    vendor = page_python.VENDOR
    assets = [
        write_asset(folder, f"vendor/{name}", (vendor / name).read_bytes())
        for name in page_python.CORE
    ]
    for name, path in wheels.files.items():
        assets.append(write_asset(folder, f"vendor/{name}.zip", trim_wheel(path)))
        _write(folder / "licenses" / f"{name}-licenses.txt", read_licenses(path))
    files = sorted(path for pattern in LIBRARY for path in ROOT.glob(pattern))
    library = ((path.relative_to(ROOT).as_posix(), path.read_bytes()) for path in files)
    assets.append(write_asset(folder, "labutils.zip", make_zip(sorted(library))))
    assets.append(write_asset(folder, WORKER, (SCRIPTS / WORKER).read_bytes()))
    assets.append(write_asset(folder, "page.zip", make_zip(collect_modules())))
    pure = (file for name in PACKAGES for file in page_widgets.collect_package(name))
    assets.append(write_asset(folder, "packages.zip", make_zip(sorted(pure))))
    parts = {"python": assets}
    for part, contents in (
        ("simulator", page_simulator.make_simulator_assets()),
        ("widgets", page_widgets.make_widget_assets()),
        ("recordings", page_recordings.make_recording_assets()),
    ):
        parts[part] = [write_asset(folder, *one) for one in sorted(contents.items())]
    tables = {
        name: write_asset(folder, f"tables/{name}.npz", (TABLES / f"{name}.npz").read_bytes())
        for name in (*read_words(), *read_completions())
    }
    scripts = (path for path in sorted(SCRIPTS.glob("*.js")) if path.name != WORKER)
    page_python.minify_scripts(scripts, folder)
    shutil.copyfile(vendor / page_python.EDITOR, folder / page_python.EDITOR)
    texts = {
        page_python.EDITOR_LICENSES: (vendor / page_python.EDITOR_LICENSES).read_text("utf-8"),
        "packages-licenses.txt": "\n".join(map(page_widgets.read_license, PACKAGES)),
        "widgets-licenses.txt": page_widgets.read_widget_licenses(),
        page_simulator.LICENSES: page_simulator.read_licenses(),
        "NOTICE.txt": NOTICE.format(version=version) + page_simulator.make_notice(),
    }
    for name, text in texts.items():
        _write(folder / "licenses" / name, text)
    manifest = {
        "version": wanted,
        "parts": parts,
        "tables": tables,
        "remote": [vars(wheel) for wheel in wheels.remote],
        "optional": find_optional(vendor / page_python.LOCK, version),
        "lock": _read_lock_info(version),
    }
    shutil.rmtree(PACKED, ignore_errors=True)
    target.rename(PACKED)
    MANIFEST.write_text(json.dumps(manifest, indent=1), encoding="utf-8")
    return manifest


def collect_modules() -> Iterator[tuple[str, bytes]]:
    """Find what runs the cells; a folder called `IPython` would hide the real one from us."""
    for path in sorted(SCRIPTS.rglob("*.py")):
        name = path.relative_to(SCRIPTS).as_posix()
        yield re.sub("^ipython/", "IPython/", name), path.read_bytes()


def count_bytes(manifest: dict[str, Any], *parts: str) -> int:
    """Add up how much of these parts travels, in bytes."""
    return sum(asset["bytes"] for part in parts for asset in manifest["parts"][part])


def write_asset(folder: Path, name: str, content: bytes) -> dict[str, Any]:
    """Write one asset as scripts; return its name, its files and its size as it travels."""
    squeezed = gzip.compress(content, 9, mtime=0)
    files = []
    for number, start in enumerate(range(0, len(squeezed), PIECE)):
        text = base64.b64encode(squeezed[start : start + PIECE]).decode("ascii")
        files.append(f"{name}.{number}.js")
        _write(folder / files[-1], f'cameraLabAsset("{name}",{number},"{text}");\n')
    return {"name": name, "files": files, "bytes": len(squeezed)}


def trim_wheel(path: Path) -> bytes:
    """Return the wheel as an archive without what the page does not need."""
    with zipfile.ZipFile(path) as wheel:
        names = [name for name in wheel.namelist() if not name.endswith("/")]
        kept = sorted(name for name in names if not DROPPED.search(name))
        return make_zip((name, wheel.read(name)) for name in kept)


def read_licenses(path: Path) -> str:
    """Join the license texts of a wheel."""
    return "\n".join(_read_license_files(path))


def _read_license_files(path: Path) -> Iterator[str]:
    with zipfile.ZipFile(path) as wheel:
        for name in sorted(filter(LICENSE.search, wheel.namelist())):
            text = wheel.read(name).decode("utf-8", errors="replace").strip()
            title = name.partition("/")[2]
            yield f"{title}\n{'=' * len(title)}\n{text}\n"


def _read_lock_info(version: str) -> dict[str, Any]:
    """Return the part of Pyodide's lock file that starts it; its packages come from here."""
    lock = json.loads((page_python.VENDOR / page_python.LOCK).read_text(encoding="utf-8"))
    return {"info": lock["info"] | {"version": version}, "packages": {}}


def _fingerprint(wheels: page_wheels.Wheels) -> str:
    """Name what `_build/page_python` should hold."""
    digest = hashlib.sha256((page_python.VENDOR / page_python.STAMP).read_bytes())
    sources = [Path(__file__), *SCRIPTS.rglob("*.*"), *TABLES.glob("*.npz"), *wheels.files.values()]
    sources += [path for pattern in LIBRARY for path in ROOT.glob(pattern)]
    sources += [*page_widgets.list_widget_sources(), *page_simulator.SOURCES.rglob("*.*")]
    sources += [page_simulator.SCENE, *page_simulator.TEXTURES.glob("*")]
    sources += [path for _, path in page_recordings.list_files()]
    for path in sorted(path for path in sources if path.is_file()):
        digest.update(path.name.encode() + b"\0" + path.read_bytes())
    engine = npm.get_checksum(page_mujoco.PACKAGE)
    digest.update(repr((wheels.remote, engine)).encode())
    return digest.hexdigest()[:16]


def _write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    sys.exit(main())
