"""Files of a design that are handed out: what the verbs of the command line write, each as one file."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from acoustic_fem.quantities.fidelity import FIDELITIES, Fidelity
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import save_design
from geometry.ground.argument_checks import check_choice
from geometry.ground.whole_files import made_folder
from studies import kit, run
from studies.panels.body_panel import save_beside
from studies.panels.cad_panel import CallbackDisplay
from studies.run.library_files import convert_library, solve_library


@dataclass(frozen=True)
class Export:
    """One file that can be had of a design."""

    title: str
    """Name of the file for people."""
    takes: str
    """How long it takes to make, in words."""
    make: Callable[[ArrayDesign, Path, Fidelity, CallbackDisplay, str | None], Path]
    """Function that writes it into a folder and hands back its path."""


def _toml(design: ArrayDesign, folder: Path, fidelity: Fidelity, display: CallbackDisplay, body: str | None) -> Path:
    path = folder / "design.toml"
    save_design(design, path)
    return path


def _library(suffix: str) -> Callable[[ArrayDesign, Path, Fidelity, CallbackDisplay, str | None], Path]:
    def make(design: ArrayDesign, folder: Path, fidelity: Fidelity, display: CallbackDisplay, body: str | None) -> Path:
        path = folder / "library.nc"
        solve_library(design, path, fidelity=fidelity, display=display)
        if suffix == path.suffix:
            return path
        other = path.with_suffix(suffix)
        convert_library(path, other)
        return other

    return make


def _parts(design: ArrayDesign, folder: Path, fidelity: Fidelity, display: CallbackDisplay, body: str | None) -> Path:
    source: ArrayDesign | Path = design
    if body is not None:  # files of the body are made for a design beside it
        source = save_beside(design, body, made_folder(folder / "design"))
    kit.export_parts(source, folder / "parts", display=display)
    return Path(shutil.make_archive(str(folder / "parts"), "zip", folder / "parts"))


def _report(design: ArrayDesign, folder: Path, fidelity: Fidelity, display: CallbackDisplay, body: str | None) -> Path:
    run.run_design(design, folder / "run", display=display)
    return folder / "run" / "report.html"


#: What can be had, by the name of the file.
EXPORTS: dict[str, Export] = {
    "design.toml": Export("the design file", "at once", _toml),
    "library.nc": Export("transfer functions, netCDF", "seconds; with 3-D cells up to a minute", _library(".nc")),
    "library.sofa": Export("transfer functions, SOFA", "as netCDF", _library(".sofa")),
    "parts.zip": Export("everything to print, cast, cut, buy and assemble", "about half a minute", _parts),
    "report.html": Export("the whole chain with a trained localizer, on one page", "minutes", _report),
}


def make_export(
    design: ArrayDesign,
    name: str,
    folder: str,
    fidelity: Fidelity,
    body: str | None = None,
    notify: Callable[[str], None] = lambda line: None,
) -> str:
    """Write one file of a design.

    Args:
        design: the array.
        name: of :data:`EXPORTS`.
        folder: exists and is empty.
        fidelity: of libraries.
        body: path of the body that the array was fitted to; None for none.
        notify: called with what is being done.

    Returns:
        Path of the file, in the folder.

    Raises:
        Refusal: no such export or fidelity, or what the verb of the command line refuses.
    """
    check_choice("export", name, EXPORTS)
    check_choice("fidelity", fidelity, FIDELITIES)
    return str(EXPORTS[name].make(design, Path(folder), fidelity, CallbackDisplay(notify), body))
