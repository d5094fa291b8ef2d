"""Touches of a made sensor that its nominal library does not know, for the tests of a calibration from them."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
from numpy.typing import NDArray
from shared import shared

import acoustic_fem
import geometry
import localize
from acoustic_fem.library.transfer_functions import Library
from localize.recalibration.self_calibration import SelfCalibration, self_calibrate
from localize.signals.array_response import response_of
from studies.test_rig.virtual_rig import HiddenScatter, Rig

GRID = np.linspace(1.0, 100.0, 24)


DESIGN = geometry.prototype("array-2x6")


NOISE = 1e-3


Array = NDArray[np.float64]


@cache
def nominal() -> Library:
    return acoustic_fem.solve(DESIGN, GRID, "lumped")


@cache
def truth(seed: int = 6, modulus: float = 0.85) -> localize.ArrayResponse:
    """A made sensor, on which the nominal library names half of the touches right."""
    h = Rig(DESIGN, seed, HiddenScatter(batch=0.0, modulus=modulus), fidelity="lumped").transfer_function(GRID)
    return replace(response_of(nominal()), transfer_function=h)


def touches(response: localize.ArrayResponse, count: int, seed: int = 1) -> tuple[Array, NDArray[np.int64]]:
    """Frames and the points nobody tells."""
    made = localize.TouchGenerator(response, seed, "training", NOISE).samples(0, count)
    return made.signals[:, :, :250].double().numpy(), made.point.numpy() - 1


@cache
def heard() -> Array:
    """160 frames, none of point 7."""
    frames, points = touches(truth(), 180)
    return frames[points != 6][:160]


@cache
def calibrated() -> SelfCalibration:
    return shared("calibrated", lambda: self_calibrate(nominal(), heard(), NOISE))
