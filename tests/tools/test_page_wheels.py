"""NumPy and OpenCV for the pages: a folder, else the official files, else the reader's network."""

import hashlib
import json
from pathlib import Path

import pytest

from tools import ROOT
from tools.vendor import page_wheels
from tools.vendor.page_wheels import Wheels

TAGS = "cp314-cp314-pyemscripten_2026_0_wasm32.whl"
NUMPY, CV2 = f"numpy-2.4.6-{TAGS}", f"opencv_python-4.11.0.86-{TAGS}"
CONTENT = {NUMPY: b"numbers", CV2: b"pictures"}


def sha256(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()


@pytest.fixture(autouse=True)
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    folder = tmp_path / "cache"
    monkeypatch.setattr(page_wheels, "CACHE", folder)
    monkeypatch.delenv(page_wheels.VARIABLE, raising=False)
    return folder


@pytest.fixture
def lock(tmp_path: Path) -> Path:
    packages = {
        name: {"file_name": file, "version": file.split("-")[1], "sha256": sha256(CONTENT[file])}
        for name, file in (("numpy", NUMPY), ("opencv-python", CV2))
    }
    path = tmp_path / "pyodide-lock.json"
    path.write_text(json.dumps({"packages": packages}))
    return path


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    path = tmp_path / "wheels"
    path.mkdir()
    for name, content in CONTENT.items():
        (path / name).write_bytes(content)
    monkeypatch.setenv(page_wheels.VARIABLE, str(path))
    return path


class Network:
    """A network that hands out files, and remembers what it was asked."""

    def __init__(self, files: dict[str, bytes] = CONTENT) -> None:
        self.files = files
        self.asked: list[str] = []

    def __call__(self, url: str) -> bytes:
        self.asked.append(url)
        name = url.rpartition("/")[2]
        if name not in self.files:
            raise OSError("no such host")
        return self.files[name]


def find(lock: Path, network: Network) -> Wheels:
    return page_wheels.find_wheels(lock, "314.0.7", network)


def write_sums(folder: Path, **wrong: str) -> None:
    sums = {name: sha256(content) for name, content in CONTENT.items()} | wrong
    lines = [f"{checksum}  {name}" for name, checksum in sums.items()]
    (folder / "SHA256SUMS").write_text("\n".join(lines))


def test_the_folder_comes_first_and_nothing_is_downloaded(lock: Path, folder: Path) -> None:
    network = Network()
    wheels = find(lock, network)
    assert wheels.files == {"numpy": folder / NUMPY, "cv2": folder / CV2}
    assert wheels.remote == ()
    assert network.asked == []
    assert "CAMERA_LAB_WHEELS" in wheels.said


def test_the_folder_may_hold_opencv_without_windows(lock: Path, folder: Path) -> None:
    headless = CV2.replace("opencv_python", "opencv_python_headless")
    (folder / CV2).rename(folder / headless)
    assert find(lock, Network()).files["cv2"].name == headless


def test_right_checksums_of_the_folder_are_accepted(lock: Path, folder: Path) -> None:
    write_sums(folder)
    assert find(lock, Network()).files["numpy"] == folder / NUMPY


def test_a_wrong_folder_is_named_and_the_build_goes_on(
    lock: Path, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / NUMPY).unlink()
    wheels = find(lock, Network())
    assert wheels.said == "the official files"
    error = capsys.readouterr().err
    assert "CAMERA_LAB_WHEELS: expected one file numpy-2.4.6-*.whl in the folder, found 0" in error


def test_a_file_that_is_not_what_the_checksums_say_is_refused(
    lock: Path, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    write_sums(folder, **{CV2: "0" * 64})
    assert find(lock, Network()).files["cv2"].parent == page_wheels.CACHE
    assert f"{CV2} is not what SHA256SUMS says (expected {'0' * 64})" in capsys.readouterr().err


def test_a_file_the_checksums_do_not_name_is_refused(
    lock: Path, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "SHA256SUMS").write_text(f"{sha256(CONTENT[CV2])} *{CV2}\n")
    find(lock, Network())
    assert f"{NUMPY} is not what SHA256SUMS says (expected no line" in capsys.readouterr().err


def test_a_wheel_for_another_machine_is_refused(
    lock: Path, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / NUMPY).rename(folder / "numpy-2.4.6-cp311-cp311-manylinux_2_17_x86_64.whl")
    find(lock, Network())
    assert f"expected a wheel for {TAGS}" in capsys.readouterr().err


def test_the_official_files_are_downloaded_once(lock: Path, cache: Path) -> None:
    network = Network()
    wheels = find(lock, network)
    assert wheels.files == {"numpy": cache / NUMPY, "cv2": cache / CV2}
    assert (cache / CV2).read_bytes() == CONTENT[CV2]
    assert network.asked == [
        f"https://cdn.jsdelivr.net/pyodide/v314.0.7/full/{name}" for name in (NUMPY, CV2)
    ]
    again = Network(files={})
    assert find(lock, again) == wheels
    assert again.asked == []


def test_a_spoiled_file_in_the_cache_is_downloaded_anew(lock: Path, cache: Path) -> None:
    find(lock, Network())
    (cache / NUMPY).write_bytes(b"half a file")
    network = Network()
    assert find(lock, network).files["numpy"].read_bytes() == CONTENT[NUMPY]
    assert len(network.asked) == 1


def test_a_download_with_a_wrong_checksum_is_not_kept(lock: Path, cache: Path) -> None:
    wheels = find(lock, Network({NUMPY: CONTENT[NUMPY], CV2: b"something else"}))
    assert wheels.files == {}
    assert [path.name for path in cache.iterdir()] == [NUMPY]
    assert f"{CV2} does not have the checksum of Pyodide's lock file" in wheels.said


def test_without_network_the_page_loads_the_official_files_itself(lock: Path) -> None:
    wheels = find(lock, Network(files={}))
    assert wheels.files == {}
    assert [(wheel.name, wheel.url.rpartition("/")[2]) for wheel in wheels.remote] == [
        ("numpy", NUMPY),
        ("cv2", CV2),
    ]
    assert [wheel.sha256 for wheel in wheels.remote] == [sha256(CONTENT[n]) for n in (NUMPY, CV2)]
    assert "its reader needs a network (no download: no such host)" in wheels.said


def test_the_lock_file_of_pyodide_names_both_wheels() -> None:
    # What is fetched by address has to be in the very version that is pinned.
    lock = ROOT / "_build" / "vendor_python" / "pyodide-lock.json"
    if not lock.is_file():
        pytest.skip("Pyodide is not there; run `make book` first")
    wheels = page_wheels.find_wheels(lock, "314.0.7", Network(files={}))
    assert [wheel.url.rpartition("/")[2] for wheel in wheels.remote] == [NUMPY, CV2]
