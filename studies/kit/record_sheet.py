"""Files that a maker fills in and ``calibrate`` reads back: the record of the build, and the manifest of recordings."""

from __future__ import annotations

from pathlib import Path

from acoustic_fem.calibration.manifest import REFERENCE
from geometry.assembly.bill import Bill
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import save_design
from geometry.ground.whole_files import write_text
from studies.kit.electronics_files import Electronics

#: Pressure of full scale where no logger states it, Pa.
_UNKNOWN_SCALE = 20.0
#: Names of the record, of the design beside it, and of the manifest of recordings.
RECORD, DESIGN, MANIFEST = "record.toml", "design.toml", "calibration.toml"


def write_record(design: ArrayDesign, bill: Bill, electronics: Electronics, folder: Path) -> Path:
    """Write the empty record, the design, and a manifest for the recordings of the calibration into a folder that
    exists. Lines of the record that nobody has measured yet are comments.

    Args:
        design: the array.
        bill: its bill of materials.
        electronics: the channels and the full scale of the recordings.
        folder: exists.

    Returns:
        Path of the record.
    """
    path = folder / RECORD
    write_text(path, record_text(design, bill))
    save_design(design.completed(), folder / DESIGN)
    write_text(folder / MANIFEST, manifest_text(design, electronics))
    return path


def manifest_text(design: ArrayDesign, electronics: Electronics) -> str:
    """Text of a manifest for recordings of every point of a design, with the channels of its wiring."""
    channels = {wire.microphone: wire.channel for wire in electronics.wires}
    loggers = electronics.levels.loggers
    scale, name = (loggers[0].full_scale, loggers[0].name) if loggers else (_UNKNOWN_SCALE, "recorder: not known")
    pascals = dict.fromkeys(design.microphones, scale) | {REFERENCE: _UNKNOWN_SCALE}
    notes = dict.fromkeys(design.microphones, name) | {REFERENCE: "not known: that of your microphone"}
    digits = len(str(design.point_count))
    lines = [
        f"# Recordings of one {design.name} for acoustic-fem calibrate: copy this file, {DESIGN} and the filled-in",
        f"# {RECORD} into the folder of the recordings. Remove the lines of points that you did not record.",
        f'design = "{DESIGN}"',
        f'record = "{RECORD}"',
        "",
        'output = "voltage"             # microphones as they are recorded, below their corner quieter',
        "",
        "[channels]                     # of the WAV files, from 1, as wiring.csv; reference: calibration microphone",
        *(f"{each} = {number}" for each, number in channels.items()),
        "",
        "[pascals]                      # pressure of full scale at 1 kHz, Pa",
        *(f"{each} = {pascals[each]:.4g}".ljust(30) + f" # {notes[each]}" for each in channels),
        "",
        "[points]",
        *(f'{number} = "point-{number:0{digits}d}.wav"' for number in range(1, design.point_count + 1)),
    ]
    return "\n".join(lines) + "\n"


def record_text(design: ArrayDesign, bill: Bill) -> str:
    """Text of the empty record of a design; it is valid as it is and then says nothing."""
    cast = next((item for item in bill.items if item.use == "cast"), None)
    silicone = "" if cast is None or cast.part is None else cast.part.name
    points = ", ".join(str(number + 1) for number in range(design.point_count))
    modulus = design.material(design.membrane.material).youngs_modulus
    lines = [
        f"# Record of one {design.name}. Take the # away from a line that you fill in.",
        f"# calibrate reads it, because {MANIFEST} names it: copy both into the folder of the recordings.",
        f'design = "{design.name}"',
        'sensor = ""                    # number on its label',
        'built = ""                     # date, such as 2026-11-27',
        'builder = ""',
        'notes = ""',
        "",
        "[measuring]",
        "thickness_error = 0.01         # mm, standard deviation of a measured thickness: your caliper, on soft rubber",
        "",
        "# One table for each cup of silicone that you mixed. Points of one batch have one modulus.",
        "[batches.1]",
        f'silicone = "{silicone}"',
        'lot = ""                       # number on the package',
        'mixed = ""                     # date',
        f"points = [{points}]",
        f"# modulus = {modulus:.3g}              # MPa, if you measured it",
        "# modulus_error = 0.05         # standard deviation of that, relative",
        "",
        "# Measured thickness of the membrane on each point, mm; the design's value stands there now.",
        "[thickness]",
    ]
    lines += [f"# {number + 1} = {thickness:g}" for number, thickness in enumerate(_thicknesses(design))]
    return "\n".join(lines) + "\n"


def _thicknesses(design: ArrayDesign) -> list[float]:
    """Thickness of the membrane of each point, mm."""
    return [design.of_kind(kind).membrane.thickness for kind in _kinds(design)]


def _kinds(design: ArrayDesign) -> list[str]:
    return [design.kinds[index] for index in design.kind_of_point]
