"""Step 3: another sensor whose signal is a hyperbola."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from solutions._completion import Case, Completion, Part, Slip


def signal_to_meters(signal: np.ndarray, close: float, distant: float) -> np.ndarray:
    """Turn the voltage of an infrared sensor into meters.

    The sensor answers ``a + b / z``. It reads 2.5 V at the distance
    `close` and 0.5 V at the distance `distant`.

    Parameters
    ----------
    signal : ndarray, float64, shape (H, W)
        Volts.
    close, distant : float
        The two known distances, meters.

    Returns
    -------
    ndarray, float, shape (H, W)
        Meters.
    """
    b = (2.5 - 0.5) / (1 / close - 1 / distant)
    a = 2.5 - b / close  # open: such that a + b / close is 2.5
    meters = b / (signal - a)  # open: signal = a + b / z, solved for z
    return meters


def _choose(cases: tuple[Case, ...]) -> tuple[Case, ...]:
    """Read the two ramps of buffers as voltages, the near plane as 2.5 V."""
    chosen = []
    for label, case in zip(("an even ramp", "a noisy picture"), (cases[0], cases[2]), strict=True):
        raw, close, distant = case.args
        share = np.clip(np.nan_to_num(raw[::2, ::2].astype(np.float64)), 0, 1)
        chosen.append(replace(case, label=label, args=(2.5 - 2 * share, close, distant)))
    return tuple(chosen)


COMPLETION = Completion(
    title="volts to meters",
    statement="The infrared sensor of the worked example answers $s = a + b/z$. Here it is "
    "measured at two other distances, which come in as arguments, and a whole picture of "
    "voltages has to become meters.",
    section="step3-worked-hyperbola",
    twin=signal_to_meters,
    parts=(Part("meters", "depth", "float", atol=1e-3, unit="m"),),
    cases=_choose,
    slips=(
        Slip(
            "no-offset",
            "the voltage at the close distance is not 2.5 V with this a. Put z = close into "
            "a + b / z and solve for a: something has to be subtracted.",
            line="a = 2.5",
        ),
        Slip(
            "not-solved",
            "this is the curve itself, not its inverse: it gives volts again. Subtract a first, "
            "then turn the fraction over.",
            line="meters = a + b / signal",
        ),
    ),
    example="""\
volts = np.array([[2.5, 1.5, 0.5]])
print(signal_to_meters(volts, 0.2, 0.8), "m, for", volts, "V")""",
)
