"""Expected result of a fit to a virtual rig: its hidden sensor in the parameters of the fitted family."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from acoustic_fem.batch.elements import membrane_modulus
from acoustic_fem.batch.parameters import ArrayParameters
from acoustic_fem.calibration.fitted_model import Posterior, UpdatedModel
from acoustic_fem.scatter.tolerances import Tolerance
from geometry.ground.typed import Array
from studies.test_rig.virtual_rig import HiddenScatter, Rig

#: Hz, where compliances of membranes are compared; and the step of a difference.
_MID_BAND, _STEP = np.array([10.0]), 1e-4
_SOURCE = "of the virtual rig"


def rig_tolerances(scatter: HiddenScatter) -> tuple[Tolerance, ...]:
    """Tolerances that a workshop with the rig's scatter would state."""
    relative = {
        "bore": scatter.bore,
        "length": scatter.length,
        "cavity_height": scatter.volume,
        "modulus_of_part": scatter.membrane,
        "modulus_of_batch": scatter.batch,
    }
    return tuple(Tolerance(quantity, deviation, "relative", _SOURCE) for quantity, deviation in relative.items())


def hidden_parameters(rig: Rig, model: UpdatedModel) -> dict[str, tuple[float, Array]]:
    """True values of what a fit states, as far as the rig's sensor has them.

    A longer tube counts as a narrower one, by the resistance, length / bore^4; a cavity counts as its membrane, by the
    compliance of both; membranes are stiffer one by one, all together and by the slope that their loss factor asks for,
    and only the product at 10 Hz is true.

    Args:
        rig: of the design of the model.
        model: the family.

    Returns:
        Name of a parameter as in ``model.names`` -> its factor against nominal, and the row (count,) float64 that takes
        the parameters of a fit to the logarithm of that factor.
    """
    nominal = model.nominal_parameters
    hidden, medium = rig.hidden, model.library.medium

    def volume(parameters: ArrayParameters) -> Array:
        area = np.pi * parameters.cavity_radius**2
        return np.asarray(area * parameters.cavity_height / (medium.gamma * medium.pressure))

    node, membrane = _compliance(hidden) + volume(hidden), _compliance(nominal)
    lossier = replace(nominal, membrane_loss=nominal.membrane_loss * np.exp(_STEP))
    by_loss = float(np.mean(np.log(_compliance(lossier) / membrane))) / _STEP
    values = np.concatenate(
        [
            np.ravel(hidden.tube_radius / nominal.tube_radius * (nominal.tube_length / hidden.tube_length) ** 0.25),
            np.ravel((node - volume(nominal)) / membrane),
            rig.gain,
            rig.corner,
            np.ravel(hidden.chamber_height / nominal.chamber_height),
        ]
    )
    rows = np.diag(model.scale)
    common = model.groups.index("modulus")
    own = [n for n, group in enumerate(model.groups) if group == "compliance"]
    rows[own, common] = -model.scale[common]
    of_loss = model.groups.index("loss")
    rows[own, of_loss] = by_loss * model.scale[of_loss]
    stated = [n for n, group in enumerate(model.groups) if group not in ("modulus", "loss")]
    return {model.names[n]: (float(value), rows[n]) for n, value in zip(stated, values, strict=True)}


def _compliance(parameters: ArrayParameters) -> Array:
    """Compliance of the membranes in mid-band, well below their modes, (n_design, n_point_column) float64, m^3/Pa."""
    return np.asarray(parameters.membrane_compliance / np.abs(membrane_modulus(parameters, _MID_BAND)[..., 0]))


def within_95(rig: Rig, fit: Posterior) -> list[tuple[str, bool]]:
    """Kind of each true value, such as ``bore``, and whether it lies in the 95 % band that the fit states."""
    found = []
    for name, (value, row) in hidden_parameters(rig, fit.model).items():
        away = np.log(value) - row @ fit.parameters
        found.append((name.split(" of ")[0], bool(abs(away) < 1.96 * np.sqrt(row @ fit.covariance @ row))))
    return found
