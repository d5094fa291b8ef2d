"""Record of a build: the TOML file that a maker fills in and that ``calibrate`` reads back."""

from __future__ import annotations

from pathlib import Path

from geometry.assembly.bill import Bill
from geometry.design.array_design import ArrayDesign
from geometry.ground.whole_files import write_text

#: Name of the file.
RECORD = "record.toml"


def write_record(design: ArrayDesign, bill: Bill, folder: Path) -> Path:
    """Write the empty record of a design into a folder that exists; lines of what was not measured are comments."""
    path = folder / RECORD
    write_text(path, record_text(design, bill))
    return path


def record_text(design: ArrayDesign, bill: Bill) -> str:
    """Text of the empty record of a design; it is valid as it is and then says nothing."""
    cast = next((item for item in bill.items if item.use == "cast"), None)
    silicone = "" if cast is None or cast.part is None else cast.part.name
    points = ", ".join(str(number + 1) for number in range(design.point_count))
    modulus = design.material(design.membrane.material).youngs_modulus
    lines = [
        f"# Record of one {design.name}. Take the # away from a line that you fill in.",
        f'# calibrate reads it: write record = "{RECORD}" into calibration.toml, and copy this file beside it.',
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
