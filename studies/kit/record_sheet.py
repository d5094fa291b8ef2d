"""Files that a maker fills in and ``calibrate`` reads back: the record of the build, and the manifest of recordings."""

from __future__ import annotations

from pathlib import Path

from geometry.assembly.bill import Bill
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import save_design
from geometry.ground.whole_files import write_text

#: Names of the record, of the design beside it, and of the manifest of recordings.
RECORD, DESIGN, MANIFEST = "record.toml", "design.toml", "calibration.toml"


def write_record(design: ArrayDesign, bill: Bill, folder: Path) -> Path:
    """Write the empty record, the design, and a manifest for the recordings of the calibration into a folder that
    exists. Lines of the record that nobody has measured yet are comments.

    Returns:
        Path of the record.
    """
    path = folder / RECORD
    write_text(path, record_text(design, bill))
    save_design(design.completed(), folder / DESIGN)
    write_text(folder / MANIFEST, manifest_text(design))
    return path


def manifest_text(design: ArrayDesign) -> str:
    """Text of a manifest for recordings of every point of a design."""
    names = ("reference", *design.microphones)
    digits = len(str(design.point_count))
    lines = [
        f"# Recordings of one {design.name} for acoustic-fem calibrate: copy this file, {DESIGN} and the filled-in",
        f"# {RECORD} into the folder of the recordings. Remove the lines of points that you did not record.",
        f'design = "{DESIGN}"',
        f'record = "{RECORD}"',
        "",
        "[channels]                     # of the WAV files, from 1; reference: the calibration microphone",
        *(f"{name} = {number}" for number, name in enumerate(names, start=1)),
        "",
        "[pascals]                      # pressure of full scale, Pa: of your recorder and your microphones",
        *(f"{name} = 20.0" for name in names),
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
