"""A state space as a file: ``.mat`` for Octave, MATLAB and Simulink, ``.npz`` for Python."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from acoustic_fem.circuit.state_space import INPUTS, OUTPUTS, SensorModel
from acoustic_fem.library.transfer_functions import VARIABLES
from geometry.ground.argument_checks import check_choice
from geometry.ground.whole_files import whole_file

#: Suffixes of state spaces.
STATE_SPACE_FORMATS = (".mat", ".npz")


def state_space_values(model: SensorModel) -> dict[str, Any]:
    """Contents of the file by name: matrices, poles and residues, and texts that say what they are."""
    system, drive, leaving, through = model.matrices
    return {
        "A": system,
        "B": drive,
        "C": leaving,
        "D": through,
        "poles": model.fit.poles,
        "residues": model.fit.residues,
        "constants": model.fit.constant,
        **{f"residues_{name}": fit.residues for name, fit in model.impedances.items()},
        **{f"constants_{name}": fit.constant for name, fit in model.impedances.items()},
        "design": model.name,
        "inputs": "\n".join(model.inputs),
        "input_quantity": model.touch,
        "input_unit": INPUTS[model.touch],
        "outputs": "\n".join(model.microphones),
        "output_quantity": model.output,
        "output_unit": OUTPUTS[model.output],
        "pole_unit": "rad/s",
        "constant_unit": f"{OUTPUTS[model.output]}/({INPUTS[model.touch]})",
        "residue_unit": f"{OUTPUTS[model.output]}/({INPUTS[model.touch]}) rad/s",
        **{f"constants_{name}_unit": VARIABLES[name][1] for name in model.impedances},
        **{f"residues_{name}_unit": f"{VARIABLES[name][1]} rad/s" for name in model.impedances},
        "band": np.array(model.band),
        "band_unit": "Hz",
        "error": model.error,
        "passivity_margin": np.nan if model.margin is None else model.margin,
        "convention": "x' = A x + B u, y = C x + D u; phasors exp(+j omega t); residues (point, microphone, pole)",
    }


def save_state_space(model: SensorModel, path: Path) -> None:
    """Write a state space; the file is whole or not there.

    Args:
        model: the state space.
        path: ends with ``.mat`` or ``.npz``.

    Raises:
        Refusal: another suffix, or a file that cannot be written.
    """
    check_choice("out: its suffix", path.suffix, STATE_SPACE_FORMATS)
    values = state_space_values(model)
    with whole_file(path) as file:
        if path.suffix == ".npz":
            np.savez(file, allow_pickle=False, **values)
        else:
            from scipy.io import savemat  # loads only where it is asked for

            savemat(file, values, do_compression=True)
