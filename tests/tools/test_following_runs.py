"""The stored runs of the chapter on following are those of its page, and can be repeated."""

from __future__ import annotations

import json
from typing import Any

import cv2
import numpy as np
import pytest
from PIL import Image

from labutils._constants import NEAR_PX
from tools.draw import following_figures, following_runs, following_video
from tools.draw.figures import FIGURES

#: Another driver may draw outlines by a pixel elsewhere, which a loop carries on.
SAME_PX = 2.0


@pytest.fixture(scope="module")
def stored() -> dict[str, Any]:
    """What the figures and the table are made from."""
    done: dict[str, Any] = json.loads(following_runs.DATA.read_text(encoding="utf-8"))
    return done


def find_scores(stored: dict[str, Any], controller: str) -> list[dict[str, float]]:
    """Return the scores of a controller's row in the table."""
    return [one["score"] for one in stored["table"] if one["controller"] == controller]


def test_the_stored_runs_are_those_of_the_page_as_it_is(stored: dict[str, Any]) -> None:
    assert stored["made_from"] == following_runs.get_stamp(), (
        "run `python -m tools.draw.following_runs`, then `python -m tools.draw.following_figures`"
    )


def test_the_table_is_made_from_the_stored_runs(stored: dict[str, Any]) -> None:
    table = following_runs.TABLE.read_text(encoding="utf-8")
    assert table == following_runs.make_table(stored)


def test_a_short_stored_run_can_be_repeated(stored: dict[str, Any]) -> None:
    place = len(following_runs.DELAYS) + 1  # the proportional controller at 50 ms
    again = following_runs.do(following_runs.make_runs()["delays"][place])
    kept = stored["delays"][place]
    assert json.loads(json.dumps(again["settings"])) == kept["settings"]
    assert again["score"]["mean_px"] == pytest.approx(kept["score"]["mean_px"], abs=SAME_PX)


@pytest.mark.slow
def test_the_stored_runs_can_be_repeated(stored: dict[str, Any]) -> None:
    again = following_runs.measure()
    for group, runs in following_runs.make_runs().items():
        for run, new, old in zip(runs, again[group], stored[group], strict=True):
            if old["score"]["mean_px"] > following_figures.EDGE_PX:
                assert new["score"]["mean_px"] > following_figures.EDGE_PX / 2, run
            else:
                near = pytest.approx(old["score"]["mean_px"], abs=SAME_PX, rel=0.1)
                assert new["score"]["mean_px"] == near, run


def test_a_worked_answer_keeps_the_books_bounds(stored: dict[str, Any]) -> None:
    scores = find_scores(stored, "worked")
    assert len(scores) == len(following_runs.SEEDS)
    for score in scores:
        assert score["mean_px"] <= NEAR_PX
        assert score["center_mm"] <= 15
        assert score["recovery_s"] <= 1


def test_each_step_of_the_page_follows_better_than_the_one_before(stored: dict[str, Any]) -> None:
    rows = [find_scores(stored, name) for name in ("open_loop", "proportional", "predicting")]
    means = [np.mean([score["mean_px"] for score in scores]) for scores in rows]
    assert means[0] > 3 * means[1]
    assert means[1] > NEAR_PX > means[2]


def test_the_pose_of_now_hides_well_and_then_swings(stored: dict[str, Any]) -> None:
    error = {
        (one["controller"], one["settings"]["delay"]): one["score"]["mean_px"]
        for one in stored["delays"]
    }
    assert error["pose_of_now", 0] == error["proportional", 0]
    assert error["pose_of_now", 1] < error["proportional", 1]
    assert error["pose_of_now", 2] > 3 * error["proportional", 2]
    swinging, settling = (one["error_px"] for one in stored["still"])
    assert max(swinging[40:60]) > 2 * max(swinging[:20])
    assert max(settling[20:]) < NEAR_PX


def test_cells_that_only_define_are_told_from_those_that_run() -> None:
    assert following_runs.is_defining(
        "import numpy as np\nA = ((0, 1), (2, 3))\ndef f():\n    pass"
    )
    assert not following_runs.is_defining("model = make()")
    assert not following_runs.is_defining("print(3)")
    assert not following_runs.is_defining("from labutils.explorers import explore_following")
    assert {"proportional", "predicting"} <= set(following_runs.load_controllers())


def test_what_was_not_measured_is_said_in_words() -> None:
    scores: list[dict[str, Any]] = [
        {"mean_px": 3.0, "center_mm": None},
        {"mean_px": 2.04, "center_mm": 1.0},
    ]
    assert following_runs.say_range(scores, "mean_px", 1, "lost") == "2.0 to 3.0"
    assert following_runs.say_range(scores, "center_mm", 1, "not told") == "not told"


@pytest.mark.parametrize("name", following_figures.DRAWINGS)
def test_every_figure_is_drawn_from_the_stored_runs(stored: dict[str, Any], name: str) -> None:
    axes = following_figures.DRAWINGS[name](stored)
    assert sum(len(one.get_lines()) for one in axes.figure.axes) >= 2
    assert (FIGURES / f"{name}.svg").is_file()


def test_the_video_shows_the_run_and_is_light() -> None:
    video = cv2.VideoCapture(str(following_video.VIDEO))
    frames = int(video.get(cv2.CAP_PROP_FRAME_COUNT))
    assert frames == following_video.SECONDS * following_video.FRAMES_PER_SECOND
    done, frame = video.read()
    assert done
    assert frame.shape == (following_video.HEIGHT, 2 * following_video.WIDTH, 3)
    assert following_video.VIDEO.stat().st_size < 500e3
    with Image.open(following_video.POSTER) as poster:
        assert poster.size == (2 * following_video.WIDTH, following_video.HEIGHT)


def test_a_cross_marks_the_middle_of_a_copy() -> None:
    picture = np.full((following_video.HEIGHT, following_video.WIDTH, 3), 90, np.uint8)
    marked = following_video.mark_middle(picture)
    rows, columns = np.nonzero(np.any(marked != 90, axis=2))
    assert (picture == 90).all()
    assert columns.mean() == pytest.approx((following_video.WIDTH - 1) / 2, abs=1)
    assert rows.mean() == pytest.approx((following_video.HEIGHT - 1) / 2, abs=1)
