"""Follow a moving ball with the head: the loop that a controller is put into, and its record.

Taught in: following.
"""

from labutils.following.ball_path import BallPath
from labutils.following.commands import command_from_pixel
from labutils.following.loop import FollowingLoop
from labutils.following.record import FollowingRecord, FollowingScore
from labutils.following.state import FollowingState
from labutils.following.things import Thing, find_thing, find_things

__all__ = [
    "BallPath",
    "FollowingLoop",
    "FollowingRecord",
    "FollowingScore",
    "FollowingState",
    "Thing",
    "command_from_pixel",
    "find_thing",
    "find_things",
]
