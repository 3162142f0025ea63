"""What of the recordings the pages can load: the stereo pairs, as they lie in the repository."""

import io
import zipfile
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from labutils import recordings
from labutils.recordings import load_recording
from tools.vendor.page_recordings import make_recording_assets


@pytest.fixture
def unpacked(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The place where the page unpacks its parts, the library beside them."""
    (content,) = make_recording_assets().values()
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        archive.extractall(tmp_path)
    monkeypatch.setattr(recordings, "CLIPS", tmp_path / "assets" / "clip")
    return tmp_path


@pytest.mark.usefixtures("unpacked")
def test_the_page_reads_the_same_pairs() -> None:
    in_page = load_recording("room")
    here = recordings.Recording(Path(__file__).parents[2] / "assets" / "clip" / "room")
    for mine, other in zip(in_page.baseline_pairs, here.baseline_pairs, strict=True):
        assert_array_equal(mine.right, other.right)
        assert_array_equal(mine.depth_right, other.depth_right)
    assert len(in_page.pairs) == len(here.pairs)
    assert np.isfinite(in_page.pairs[0].depth).all()


def test_the_page_says_that_it_has_no_keyframes(unpacked: Path) -> None:
    with pytest.raises(FileNotFoundError, match=r"0000.*the pages bring the stereo pairs alone"):
        _ = load_recording("room").keyframes
    assert not list(unpacked.rglob("walk"))


def test_the_same_clip_gives_the_same_bytes() -> None:
    assert make_recording_assets() == make_recording_assets()
