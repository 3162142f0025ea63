"""The library's pictures are those of MuJoCo's own renderer, from a state nobody forwarded."""

from __future__ import annotations

import pytest

from tests.foreign.measuring import measure
from tests.foreign.views import VIEWS, View


@pytest.mark.parametrize("view", VIEWS, ids=str)
def test_color_and_depth_are_those_drawn_by_hand_after_a_forward(view: View) -> None:
    # posed and never forwarded, and after steps, when positions lag behind
    assert measure(view).differing_pixels == 0


@pytest.mark.parametrize("view", VIEWS, ids=str)
def test_drawing_changes_neither_state_nor_what_dynamics_computed(view: View) -> None:
    assert measure(view).changed == []


def test_there_are_cameras_of_every_kind_and_peer() -> None:
    kinds = {measure(view).kind for view in VIEWS}
    assert kinds == {"fixed", "tracking", "targeting", "free"}
    assert {view.peer for view in VIEWS} == {"dm_control", "robosuite", "gymnasium"}
    assert len(VIEWS) >= 12
