"""Sensors of the virtual rig as arrays, for benchmarks: hidden deviations that no library has."""

from __future__ import annotations

import tempfile
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

import numpy as np

import geometry
from acoustic_fem.numerics.frequency_splines import interpolated
from localize.signals.array_response import ArrayResponse, response_of
from studies.test_rig.calibrating import calibrate_sensor
from studies.test_rig.virtual_rig import Recorder, Rig

#: Frequencies, Hz: the rig's sensors are not heard beyond.
HEARD = np.geomspace(0.5, 160.0, 150)


def made_sensors(response: ArrayResponse, design: str, seeds: Iterable[int]) -> tuple[ArrayResponse, ...]:
    """As-built sensors of a design, with the noise of its microphones and the response of its cavities to a force.

    Args:
        response: of the design, over 0.5 to 160 Hz at least.
        design: name of the prototype.
        seeds: one for each sensor.
    """
    cavity = response.cavity_response
    bare = {
        "frequency": HEARD,
        "ambient_response": None,
        "vent_ratio": None,
        "cavity_response": None if cavity is None else interpolated(cavity, response.frequency, HEARD),
        "sealed": False,
        "closed_form": None,
    }
    rigs = (Rig(geometry.prototype(design), seed, fidelity="lumped") for seed in seeds)
    return tuple(replace(response, transfer_function=each.transfer_function(HEARD), **bare) for each in rigs)


def calibrated(design: str, seeds: Iterable[int]) -> tuple[ArrayResponse, ...]:
    """The same sensors as `calibrate` measures them, from a recording of half a minute of every point.

    Args:
        design: name of the prototype.
        seeds: one for each sensor.
    """
    found = []
    for seed in seeds:
        rig = Rig(geometry.prototype(design), seed, fidelity="lumped")
        with tempfile.TemporaryDirectory() as folder:
            recordings = Path(folder) / "recordings"
            rig.record(recordings, range(1, rig.design.point_count + 1), Recorder(seconds=30.0))
            found.append(
                response_of(calibrate_sensor(recordings, Path(folder) / "library.nc", fidelity="lumped").library)
            )
    return tuple(found)
