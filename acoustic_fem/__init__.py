"""Acoustics of a tactile array, in SI units with time convention exp(+j omega t).

Names are loaded when they are first used, so that ``import acoustic_fem`` costs nothing.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from acoustic_fem.library import FIDELITIES, Library
    from acoustic_fem.library_file import LibraryError, load, save
    from acoustic_fem.medium import Medium
    from acoustic_fem.solving import solve

_HOMES = {
    "FIDELITIES": "library",
    "Library": "library",
    "LibraryError": "library_file",
    "Medium": "medium",
    "load": "library_file",
    "save": "library_file",
    "solve": "library",
}
_MODULES = (
    "batch_network",
    "batch_parameters",
    "calibration",
    "calibration_manifest",
    "cavity",
    "cell",
    "coil_bore",
    "design_cells",
    "duct",
    "exchange",
    "frequency",
    "helmholtz",
    "library",
    "linear_solver",
    "lumped_cell",
    "medium",
    "membrane",
    "microphone",
    "model_updating",
    "navier_stokes",
    "network",
    "noise",
    "opening",
    "section",
    "tapered_duct",
    "transfer_estimate",
    "units",
)

__all__ = ["FIDELITIES", "Library", "LibraryError", "Medium", "load", "save", "solve"]


def __getattr__(name: str) -> Any:
    if name in _HOMES:
        return getattr(import_module(f"acoustic_fem.{_HOMES[name]}"), name)
    if name in _MODULES:
        return import_module(f"acoustic_fem.{name}")
    raise AttributeError(f"module 'acoustic_fem' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*__all__, *_MODULES})
