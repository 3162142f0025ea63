"""What the pages load for Python: packed alike every time, small, and with nothing secret in it."""

import base64
import gzip
import io
import itertools
import json
import re
import shutil
import subprocess
import sys
import zipfile
from collections.abc import Iterable
from pathlib import Path
from typing import Any, NoReturn

import pytest

from labutils.checks.table import TABLES, read_completions, read_words
from solutions import load_exercises
from tests.helpers.leaks import collect_secrets, find_leaks, read_document
from tools.vendor import (
    npm,
    pack_python,
    page_python,
    page_recordings,
    page_simulator,
    page_wheels,
    page_widgets,
)
from tools.vendor.page_wheels import Wheels

ROOT = Path(__file__).resolve().parents[2]
REAL_MANIFEST, REAL_PACKED = pack_python.MANIFEST, pack_python.PACKED
BUDGET = 13_000_000  # bytes, gzipped, on the first click
SIMULATOR_BUDGET = 3_000_000  # on top, with the first cell that simulates
RECORDINGS_BUDGET = 3_000_000  # on top, with the first cell that reads a recording
EDITOR_BUDGET = 160e3  # loaded with the exercises, and with the first Edit of a chapter
PIECE = re.compile(r'cameraLabAsset\("([^"]+)",(\d+),"([A-Za-z0-9+/=]*)"\);\n')


def unpack(folder: Path, asset: dict[str, Any]) -> bytes:
    """Put an asset together as the page does."""
    pieces = []
    for number, file in enumerate(asset["files"]):
        piece = PIECE.fullmatch((folder / file).read_text())
        assert piece, file
        name, place, text = piece.groups()
        assert (name, int(place)) == (asset["name"], number)
        pieces.append(base64.b64decode(text))
    assert sum(map(len, pieces)) == asset["bytes"]
    return gzip.decompress(b"".join(pieces))


def make_wheel(path: Path, **extra: str) -> Path:
    names = ["pkg/__init__.py", "pkg/tests/test_x.py", "pkg/_core/include/x.h", "pkg/x.pyi"]
    names += ["pkg/f2py/__init__.py", "pkg/f2py/rules.py", "pkg/lib.so"]
    members = dict.fromkeys(names, "x") | {"pkg-1.dist-info/licenses/LICENSE.txt": "Free."} | extra
    with zipfile.ZipFile(path, "w") as wheel:
        for name, content in members.items():
            wheel.writestr(name, content)
    return path


def copy_scripts(scripts: Iterable[Path], target: Path) -> None:
    for path in scripts:
        shutil.copyfile(path, target / path.name)


@pytest.fixture(autouse=True)
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Pack into a folder of the test, from a small stand-in for Pyodide and its wheels."""
    vendor = tmp_path / "vendor"
    vendor.mkdir()
    for name in (*page_python.CORE, page_python.EDITOR, page_python.EDITOR_LICENSES):
        (vendor / name).write_bytes(name.encode() * 1000)
    (vendor / page_python.STAMP).write_text("1")
    (vendor / page_python.LOCK).write_text('{"info": {"python": "3.14.2"}, "packages": {}}')
    # what the simulator and the widgets consist of has tests of its own
    small = {"simulator.zip": b"s" * 100, "vendor/mujoco.wasm": b"w" * 100}
    monkeypatch.setattr(page_simulator, "make_simulator_assets", lambda: small)
    monkeypatch.setattr(page_widgets, "make_widget_assets", lambda: {"widgets.zip": b"x" * 100})
    clips = {"recordings.zip": b"r" * 100}
    monkeypatch.setattr(page_recordings, "make_recording_assets", lambda: clips)
    monkeypatch.setattr(page_python, "minify_scripts", copy_scripts)
    monkeypatch.setattr(page_python, "VENDOR", vendor)
    monkeypatch.setattr(pack_python, "PACKED", tmp_path / "packed")
    monkeypatch.setattr(pack_python, "MANIFEST", tmp_path / "packed.json")
    return tmp_path


@pytest.fixture
def wheels(tmp_path: Path) -> Wheels:
    files = {name: make_wheel(tmp_path / f"{name}-1-x.whl") for name in ("numpy", "cv2")}
    return page_wheels.Wheels("a test", files)


def read_all(folder: Path) -> dict[str, bytes]:
    files = sorted(path for path in folder.rglob("*") if path.is_file())
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in files}


def test_two_builds_give_the_same_bytes(wheels: Wheels) -> None:
    first = pack_python.pack(wheels, "1.0")
    before = read_all(pack_python.PACKED)
    for path in wheels.files.values():
        make_wheel(path)  # the same content with other times
    pack_python.MANIFEST.unlink()
    again = pack_python.pack(wheels, "1.0")
    assert read_all(pack_python.PACKED) == before
    assert {**first, "version": ""} == {**again, "version": ""}


def test_nothing_is_packed_twice_and_a_change_is_seen(
    wheels: Wheels, monkeypatch: pytest.MonkeyPatch
) -> None:
    manifest = pack_python.pack(wheels, "1.0")
    with monkeypatch.context() as patch:
        patch.setattr(pack_python, "write_asset", lambda *_: pytest.fail("packed again"))
        assert pack_python.pack(wheels, "1.0") == manifest
    make_wheel(wheels.files["cv2"], **{"pkg/new.py": "y"})
    assert pack_python.pack(wheels, "1.0")["version"] != manifest["version"]


def test_a_large_asset_comes_in_pieces(place: Path) -> None:
    content = bytes(range(256)) * 20_000
    noise = gzip.compress(content, 0)  # about as large as before
    asset = pack_python.write_asset(place, "x.bin", noise[: pack_python.PIECE] + noise)
    assert unpack(place, asset) == noise[: pack_python.PIECE] + noise


def test_wheels_lose_what_no_reader_needs(wheels: Wheels) -> None:
    with zipfile.ZipFile(io.BytesIO(pack_python.trim_wheel(wheels.files["cv2"]))) as archive:
        assert archive.namelist() == ["pkg/__init__.py", "pkg/f2py/__init__.py", "pkg/lib.so"]


def test_licenses_are_shipped_beside_the_assets(wheels: Wheels) -> None:
    pack_python.pack(wheels, "1.0")
    licenses = read_all(pack_python.PACKED / "python" / "licenses")
    assert set(licenses) == {
        "NOTICE.txt",
        "cv2-licenses.txt",
        "editor-licenses.txt",
        "mujoco-licenses.txt",
        "numpy-licenses.txt",
        "packages-licenses.txt",
        "widgets-licenses.txt",
    }
    assert b"Free." in licenses["numpy-licenses.txt"]
    assert b"https://mozilla.org/MPL/2.0/" in licenses["NOTICE.txt"]


def test_wheels_that_could_not_be_had_are_left_to_the_page() -> None:
    remote = (page_wheels.RemoteWheel("numpy", "https://cdn.example/numpy.whl", "ab"),)
    manifest = pack_python.pack(page_wheels.Wheels("nobody", remote=remote), "1.0")
    assert manifest["remote"] == [
        {"name": "numpy", "url": "https://cdn.example/numpy.whl", "sha256": "ab"}
    ]
    assert not [asset for asset in manifest["parts"]["python"] if "numpy" in asset["name"]]


def test_the_library_is_the_one_of_the_notebook(wheels: Wheels) -> None:
    manifest = pack_python.pack(wheels, "1.0")
    (library,) = [asset for asset in manifest["parts"]["python"] if asset["name"] == "labutils.zip"]
    with zipfile.ZipFile(io.BytesIO(unpack(pack_python.PACKED / "python", library))) as archive:
        names = archive.namelist()
        for name in names:
            assert archive.read(name) == (ROOT / name).read_bytes()
    assert {"labutils/__init__.py", "labutils/checks/gates.py"} <= set(names)
    assert "labutils/checks/tables/exercises.json" in names
    assert not [name for name in names if name.endswith(".npz")]


def test_packed_library_checks_an_answer_by_itself(wheels: Wheels, tmp_path: Path) -> None:
    manifest = pack_python.pack(wheels, "1.0")
    (library,) = [asset for asset in manifest["parts"]["python"] if asset["name"] == "labutils.zip"]
    with zipfile.ZipFile(io.BytesIO(unpack(pack_python.PACKED / "python", library))) as archive:
        archive.extractall(tmp_path)
    name = "intrinsics_matrix"
    content = (TABLES / f"{name}.npz").read_bytes()
    (tmp_path / TABLES.relative_to(ROOT) / f"{name}.npz").write_bytes(content)
    code = (
        "import sys; sys.path.insert(0, '.'); import labutils, numpy as np;"
        f"print(labutils.__file__, labutils.check({name!r}, lambda *_: np.eye(3)).property)"
    )
    done = subprocess.run(
        [sys.executable, "-I", "-c", code], cwd=tmp_path, capture_output=True, text=True, check=True
    )
    assert done.stdout.split() == [str(tmp_path / "labutils" / "__init__.py"), "value"]


def test_tables_come_one_by_one(wheels: Wheels) -> None:
    manifest = pack_python.pack(wheels, "1.0")
    folder = pack_python.PACKED / "python"
    assert sorted(manifest["tables"]) == sorted([*read_words(), *read_completions()])
    for name, asset in manifest["tables"].items():
        tables = ROOT / "labutils" / "checks" / "tables"
        assert unpack(folder, asset) == (tables / f"{name}.npz").read_bytes()


def test_what_is_ours_in_the_assets_holds_no_leak(wheels: Wheels) -> None:
    manifest = pack_python.pack(wheels, "1.0")
    base = manifest["parts"]["python"]
    ours = [asset for asset in base if not asset["name"].startswith("vendor/")]
    assert {asset["name"] for asset in ours} == {
        "labutils.zip",
        "packages.zip",
        "page.zip",
        "worker.js",
    }
    folder = pack_python.PACKED / "python"
    documents: list[tuple[str, str]] = []
    for asset in (*ours, *manifest["tables"].values()):
        documents += read_document(asset["name"], unpack(folder, asset))
    assert len(documents) > len(manifest["tables"])
    assert find_leaks(collect_secrets(load_exercises().values()), documents) == []


def test_a_first_click_loads_less_than_its_budget() -> None:
    if not REAL_MANIFEST.is_file():
        pytest.skip("Python in the page is not packed; run `make book` first")
    manifest = json.loads(REAL_MANIFEST.read_text())
    if manifest["remote"]:
        pytest.skip("NumPy and OpenCV are loaded from the CDN: nobody knows their size here")
    every = [*itertools.chain(*manifest["parts"].values()), *manifest["tables"].values()]
    for asset in every:
        unpack(REAL_PACKED / "python", asset)  # has the size that the manifest says
    largest = max(asset["bytes"] for asset in manifest["tables"].values())
    assert pack_python.count_bytes(manifest, "python") + largest < BUDGET
    assert pack_python.count_bytes(manifest, "simulator") < SIMULATOR_BUDGET
    assert pack_python.count_bytes(manifest, "recordings") < RECORDINGS_BUDGET


def test_the_editor_is_made_of_locked_packages() -> None:
    closure = npm.list_closure(page_python.EDITOR_PACKAGES)
    assert {"@codemirror/view", "@lezer/python", "style-mod"} <= set(closure)
    for name in closure:
        assert npm.get_checksum(name).startswith("sha512-")


def test_the_editor_stays_small() -> None:
    editor = REAL_PACKED / "python" / page_python.EDITOR
    if not editor.is_file():
        pytest.skip("the editor is not there; run `make book` first")
    assert len(gzip.compress(editor.read_bytes(), 9)) < EDITOR_BUDGET


def test_an_editor_that_cannot_be_bundled_stops_the_build(
    place: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    entry = place / "entry.js"
    entry.write_text("import { nothing } from 'nowhere';")
    monkeypatch.setattr(page_python, "ENTRY", entry)
    if not (ROOT / "_build" / "page_python").is_dir():
        pytest.skip("the packages are not there; run `make book` first")
    try:
        npm.install()
    except npm.VendorError as error:
        pytest.skip(f"no network: {error}")
    with pytest.raises(npm.VendorError, match=r"could not be bundled.*nowhere"):
        page_python.bundle_editor(place)


def test_without_npm_and_without_older_files_the_build_stops(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def fail() -> NoReturn:
        raise npm.VendorError("npm could not fetch pyodide")

    monkeypatch.setattr(npm, "install", fail)
    assert "going on with the older files" in page_python.vendor()
    (page_python.VENDOR / page_python.STAMP).unlink()
    assert pack_python.main() == 1
    assert "python in the page: npm could not fetch pyodide" in capsys.readouterr().err
