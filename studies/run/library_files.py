"""Libraries as files: solved for a design, brought into another format, and fitted by a state space."""

from __future__ import annotations

from functools import partial
from pathlib import Path

import acoustic_fem
from acoustic_fem import Library
from acoustic_fem.circuit import (
    NETLIST_FORMAT,
    STATE_SPACE_FORMATS,
    SensorCircuit,
    SensorModel,
    check_ports,
    is_touchstone,
)
from acoustic_fem.library.exchange import FORMATS, load, write_library
from acoustic_fem.library.foreign_sofa import library_from_sofa
from acoustic_fem.quantities.checks import FrequencyLike
from acoustic_fem.quantities.fidelity import CLOSED_FORMS, ONE_DESIGN
from acoustic_fem.quantities.local_air import LocalAir, checked_air
from geometry.design.design_file import DesignLike, resolve_design
from geometry.ground.argument_checks import check_choice, check_unused
from geometry.ground.extras import check_extras
from geometry.ground.missing_packages import check_system_libraries
from geometry.ground.refusal import Field, Kind, Refusal, counted
from geometry.ground.typed import PathLike
from studies.output.call_defaults import CONTENTS, STATE_SPACE_ERROR
from studies.output.display import Display
from studies.output.folders import check_new_file, check_new_library, claimed_file
from studies.output.frequencies import LIBRARY_FREQUENCIES

#: Files of a circuit, in words.
_CIRCUITS = f"{NETLIST_FORMAT} or a Touchstone file such as .s14p"


def solve_library(
    design: DesignLike,
    out: PathLike,
    *,
    fidelity: str = ONE_DESIGN,
    frequency: FrequencyLike = LIBRARY_FREQUENCIES,
    air: LocalAir | None = None,
    display: Display | None = None,
) -> Library:
    """Library of a design, which is also written to a file: transfer functions from every point to every microphone.

    Args:
        design: the array: a design, the path of its file, or the name of a prototype.
        out: the library to write, netCDF (``.nc``); a computed library is replaced, but a measured one is never
            overwritten.
        fidelity: see :func:`acoustic_fem.solve`.
        frequency: (n_freq,) Hz, ascending, or FIRST:LAST:COUNT.
        air: air of the place where the sensor is used; values that you do not give are those of the design.
        display: shows progress, then a line for each distinct cell.

    Raises:
        Refusal: a file that cannot be written, a bad frequency, fidelity or air, or a design that cannot be solved.
    """
    checked_air(air)
    path, show, design = Path(out), display or Display(), resolve_design(design)
    check = partial(check_new_library, path, (".nc",))
    check()
    if fidelity not in CLOSED_FORMS:
        check_extras("what solves in 3-D", "fem")
        check_system_libraries()
    with claimed_file(path, check), show.stage("Cells") as report:
        library = acoustic_fem.solve(design, frequency, fidelity, air, report)
        write_library(library, path)
    for line in cell_lines(library):
        show.note(line)
    return library


def convert_library(
    library: PathLike,
    out: PathLike,
    *,
    content: str | None = None,
    touch: str | None = None,
    output: str | None = None,
    tolerance: float | None = None,
    design: DesignLike | None = None,
) -> Library | SensorModel | SensorCircuit:
    """Library that was read from a file and written in another format, or as a state space or a circuit.

    Args:
        library: the file to read: netCDF (``.nc``), SOFA (``.sofa``), ``.npz``, ``.mat`` or ``.csv``.
        out: the file to write, with one of these suffixes, ``.npz`` or ``.mat`` for a state space, ``.cir`` for a
            circuit, or ``.s14p`` for the impedances between its 14 ports. Measured libraries and Touchstone files are
            never overwritten.
        content: "library", "state-space" or "circuit"; by default a circuit for ``.cir`` and Touchstone files, and else
            a library.
        touch: input of a state space at each membrane: "force" (N), the default, or "volume-velocity" (m^3/s).
        output: output of a state space at each microphone: "pressure" (Pa) in front of it, the default, or its
            "voltage" (V).
        tolerance: largest error of a state space, relative to the magnitude of each response at each frequency; 1e-3
            by default.
        design: the array of a SOFA file that another program wrote: a design, the path of its file, or the name of a
            prototype; see :func:`acoustic_fem.library.library_from_sofa`. All other files state their design.

    Returns:
        The library, the state space that was fitted, or the circuit.

    Raises:
        Refusal: a file that is not a library, or cannot be written; ``touch``, ``output`` or ``tolerance`` of anything
            but a state space; a state space that does not keep the error.
    """
    path = Path(out)
    others = ""
    if content is None:
        content = "circuit" if _is_circuit(path) else "library"
        others = f"; or a circuit, {_CIRCUITS}"
    check_choice("content", content, CONTENTS)
    if content != "state-space":
        what = "a circuit has its own pins for" if content == "circuit" else "a library has"
        remedy = ("leave it out, or ask for a state space with ", Field("content"), " state-space")
        given = {"touch": touch, "output": output, "tolerance": tolerance}
        check_unused(given, f": {what} all inputs and outputs, and no fit", remedy)
    if content == "library":
        with claimed_file(path, partial(check_new_library, path, FORMATS, (library,), others)):
            loaded = _opened(library, design)
            write_library(loaded, path)
        return loaded
    if content == "circuit":
        with claimed_file(path, partial(_check_model, path, library, "a circuit", (NETLIST_FORMAT,))):
            loaded = _opened(library, design)
            if is_touchstone(path):
                check_ports(path, loaded.design.point_count, len(loaded.design.microphones))
            sensor = acoustic_fem.circuit.sensor_circuit(loaded)
            if is_touchstone(path):
                acoustic_fem.circuit.save_touchstone(sensor, loaded.frequency, path)
            else:
                acoustic_fem.circuit.save_netlist(sensor, path)
        return sensor
    with claimed_file(path, partial(_check_model, path, library, "a state space", STATE_SPACE_FORMATS)):
        model = acoustic_fem.circuit.fit_sensor(
            _opened(library, design),
            touch="force" if touch is None else touch,
            output="pressure" if output is None else output,
            tolerance=STATE_SPACE_ERROR if tolerance is None else tolerance,
        )
        acoustic_fem.circuit.save_state_space(model, path)
    return model


def _opened(library: PathLike, design: DesignLike | None) -> Library:
    path = Path(library)
    return load(path) if design is None else library_from_sofa(path, design)


def _check_model(path: Path, library: PathLike, what: str, formats: tuple[str, ...]) -> None:
    touchstone = NETLIST_FORMAT in formats and is_touchstone(path)
    if path.suffix.lower() not in formats and not touchstone and not path.is_dir():
        allowed = f"{what}, {_CIRCUITS if NETLIST_FORMAT in formats else ' or '.join(formats)}"
        raise Refusal(kind=Kind.OUT_OF_RANGE, file=path, field=Field("out"), allowed=allowed)
    # A circuit can be made again; a .npz or a .mat may be a measured library, and Touchstone files are often measured.
    kept = "a file that may be a measurement" if touchstone else "a file that may be a measured library"
    check_new_file(path, reads=(library,), kept=None if path.suffix.lower() == NETLIST_FORMAT else kept)


def _is_circuit(path: Path) -> bool:
    return path.suffix.lower() == NETLIST_FORMAT or is_touchstone(path)


def cell_lines(library: Library) -> list[str]:
    """Lines of text, one for each distinct cell of a library: from the cache or solved, unknowns, seconds."""
    lines = []
    for cell in library.provenance["cells"]:
        if "unknowns" not in cell:
            lines.append(f"{cell['cell']}: {cell['method']}")
        elif "cached" not in cell:  # the clock of files is stopped
            lines.append(f"{cell['cell']}: {counted(cell['unknowns'], 'unknown')}")
        elif cell["cached"]:
            lines.append(f"{cell['cell']}: from the cache ({counted(cell['unknowns'], 'unknown')})")
        else:
            lines.append(
                f"{cell['cell']}: {counted(cell['unknowns'], 'unknown')} solved at {len(cell['sampled_frequencies'])} "
                f"frequencies in {cell['seconds']:.1f} s"
            )
    return lines
