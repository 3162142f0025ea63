"""What the page's package knows of the real one is derived, and a change is told in full."""

from __future__ import annotations

import gzip
import json
import re
from pathlib import Path

import mujoco
import pytest

from tools import ROOT
from tools.derive import page_mujoco
from tools.derive import page_mujoco_functions as functions
from tools.derive.page_mujoco_scene import make_page_scene
from tools.vendor import npm, page_simulator


def test_the_committed_file_is_what_is_derived() -> None:
    npm.install()
    assert page_mujoco.find_difference() == ""


def test_a_change_is_shown_line_by_line(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    changed = tmp_path / "derived.json"
    text = page_mujoco.DERIVED.read_text("utf-8")
    changed.write_text(text.replace('"geom_size": "f8 ngeom 3"', '"geom_size": "f8 ngeom 4"'))
    monkeypatch.setattr(page_mujoco, "DERIVED", changed)
    assert page_mujoco.main(["--check"]) == 1
    said = capsys.readouterr().err
    assert "is not what is derived now; run `make exercises`" in said
    assert '-"geom_size": "f8 ngeom 4",\n+"geom_size": "f8 ngeom 3",' in said
    with pytest.raises(npm.VendorError, match="run `make exercises`"):
        page_simulator.make_simulator_assets()


def test_without_the_engine_nothing_is_derived(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def fail() -> str:
        raise npm.VendorError("npm could not fetch the packages")

    monkeypatch.setattr(npm, "install", fail)
    assert page_mujoco.main([]) == 1
    assert capsys.readouterr().err == "page mujoco: npm could not fetch the packages\n"


def test_a_signature_is_written_in_short() -> None:
    text = functions.shorten(mujoco.mj_ray.__doc__)
    assert text.startswith("m:MjModel d:MjData pnt:f8[3,1] vec:f8[3,1] geomgroup:u1[6,1]? ")
    assert text.endswith(" geomid:i4[1,1]w? normal:f8[3,1]w?=None -> float")


def test_functions_that_want_sizes_are_those_the_package_gives_sizes() -> None:
    text = (page_simulator.SOURCES / "mujoco" / "_functions.py").read_text("utf-8")
    table = re.search(r"^_SIZES.*?^\}", text, re.MULTILINE | re.DOTALL)
    assert table is not None
    assert sorted(re.findall(r'"(mju_\w+)"', table[0])) == sorted(functions.WITH_SIZES)


def test_the_scene_of_the_page_is_the_scene_of_the_book() -> None:
    ours = mujoco.MjModel.from_xml_path(str(page_simulator.SCENE))
    text = make_page_scene(page_simulator.SCENE)
    assert "replicate" not in text
    assert not re.search(r"<geom\b[^>]*castshadow", text)
    files = {path.name: path.read_bytes() for path in page_simulator.TEXTURES.glob("*.png")}
    theirs = mujoco.MjModel.from_xml_string(text, files)
    for name in dir(ours):
        value = getattr(ours, name)
        is_array = hasattr(value, "shape") and not name.startswith("_")
        if is_array and name not in ("geom_castshadow", "tex_pathadr"):
            # quaternions of copies are normalized once more
            gap = abs(value.astype(float) - getattr(theirs, name)).max(initial=0)
            assert gap < 1e-12, name
    assert ours.names == theirs.names


def test_a_replicate_that_cannot_be_expanded_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "scene.xml"
    path.write_text(
        "<mujoco><worldbody><replicate count='2'><body><geom name='a' size='1'/></body></replicate>"
        "</worldbody></mujoco>"
    )
    with pytest.raises(ValueError, match="expected one geom with a name in it"):
        make_page_scene(path)


def test_the_assets_are_small_and_the_same_every_time() -> None:
    assets = page_simulator.make_simulator_assets()
    assert assets == page_simulator.make_simulator_assets()
    assert list(assets) == [
        "vendor/mujoco.js",
        "vendor/mujoco.wasm",
        "simulator.js",
        "simulator.zip",
    ]
    assert sum(len(gzip.compress(content, 9)) for content in assets.values()) < 3e6


def test_the_engine_comes_with_its_licenses() -> None:
    lock = json.loads((ROOT / "package-lock.json").read_text("utf-8"))
    version = lock["packages"]["node_modules/@mujoco/mujoco"]["version"]
    assert f"MuJoCo {version}" in page_simulator.make_notice()
    assert page_simulator.LICENSES in page_simulator.make_notice()
    assert "Apache License" in page_simulator.read_licenses()
    assert "qhull" in page_simulator.read_licenses().lower()
