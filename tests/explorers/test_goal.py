"""A goal of an explorer: what holds, what does not, and what cannot be one."""

from __future__ import annotations

import math

import pytest

from labutils.explorers._goal import Goal, GoalPart

IOU = GoalPart("iou", "IoU", low=0.9)
ANGLE = GoalPart("angle_deg", "angle", low=89.5, high=90.5, unit="°", digits=1)


@pytest.mark.parametrize(
    ("iou", "angle", "holds"),
    [(0.9, 90.0, True), (0.89, 90.0, False), (1.0, 90.6, False), (1.0, 89.5, True)],
)
def test_a_goal_holds_where_every_part_does(iou: float, angle: float, holds: bool) -> None:
    assert Goal("Both", IOU, ANGLE).holds({"iou": iou, "angle_deg": angle}) is holds


@pytest.mark.parametrize("value", [None, math.nan])
def test_no_value_reaches_nothing(value: float | None) -> None:
    assert not Goal("Overlap", IOU).holds({"iou": value})


def test_a_goal_travels_to_the_page_and_back() -> None:
    goal = Goal("Both", IOU, ANGLE)
    assert Goal.from_trait(goal.to_trait()) == goal
    assert Goal.from_trait({}) is None


def test_what_cannot_be_reached_is_refused() -> None:
    with pytest.raises(ValueError, match="IoU: expected low, high or both, got neither"):
        GoalPart("iou", "IoU")
    with pytest.raises(ValueError, match="IoU: expected low <= high, got 2 and 1"):
        GoalPart("iou", "IoU", low=2, high=1)
    with pytest.raises(ValueError, match="IoU: expected a scale above 0, got 0"):
        GoalPart("iou", "IoU", low=1, scale=0)
    with pytest.raises(ValueError, match="parts: expected at least one, got none"):
        Goal("Nothing")
