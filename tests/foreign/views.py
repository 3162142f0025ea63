"""Which cameras of which models are looked through: data only, no peer is imported here."""

from __future__ import annotations

from dataclasses import dataclass

WIDTH, HEIGHT = 640, 480

#: A camera of no model: the one that a viewer or a peer takes where nobody names another.
FREE = "free"


@dataclass(frozen=True)
class View:
    """A camera of a peer's model; `camera` is its name, or `FREE`."""

    peer: str
    model: str
    camera: str

    def __str__(self) -> str:
        return f"{self.peer}-{self.model}-{self.camera}"


_CAMERAS = {
    "dm_control": {
        "acrobot.swingup": ("lookat",),
        "cartpole.balance": ("fixed", "lookatcart"),
        "cheetah.run": ("side", "back"),
        "dog.stand": ("y-axis", "x-axis"),
        "finger.spin": ("cam0",),
        "fish.upright": ("tracking_x", "fixed_top"),
        "hopper.stand": ("cam0",),
        "humanoid.stand": ("back", "side", "egocentric", FREE),
        "humanoid_CMU.stand": ("side",),
        "manipulator.bring_ball": ("fixed", "hand"),
        "quadruped.escape": ("global", "x", "egocentric"),
        "stacker.stack_2": ("hand",),
        "swimmer.swimmer6": ("tracking1", "eyes"),
        "walker.stand": ("side", FREE),
    },
    "robosuite": {
        "Lift": ("agentview", "frontview", "birdview", "robot0_eye_in_hand"),
        "Door": ("agentview", "robot0_eye_in_hand"),
    },
    "gymnasium": {
        "Ant-v5": ("track", FREE),
        "HalfCheetah-v5": ("track",),
        "Humanoid-v5": ("track", FREE),
        "Pusher-v5": (FREE,),
        "Reacher-v5": (FREE,),
        "Walker2d-v5": ("track",),
    },
}

VIEWS = tuple(
    View(peer, model, camera)
    for peer, models in _CAMERAS.items()
    for model, cameras in models.items()
    for camera in cameras
)
