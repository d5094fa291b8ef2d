"""Volumes of silicone and steps of a cast in words: for the manual, and as a file beside the mold."""

from __future__ import annotations

import csv
import io
from pathlib import Path

from geometry.assembly.bill import Bill
from geometry.assembly.model import ArrayModel
from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import counted
from geometry.ground.whole_files import write_text
from geometry.molds.mold_filling import CLOSING_FORCE, CLOSING_TIME, OVERFILL
from geometry.stock import Silicone, catalogue
from studies.kit.build_facts import SMALLEST_BATCH, Cast, casts_of

#: Columns of ``casting.csv``.
_COLUMNS = (
    *("membrane", "needed", "cavities", "casts", "in_cavities_ml", "overflow_ml", "in_cup_ml", "mixed_ml", "mixed_g"),
    *("wasted", "opening_force_n", "batch_g", "batch_ml", "spare"),
)


def casting_words(cast: Cast) -> str:
    """Number of casts of a membrane, and the silicone of one."""
    left = cast.mixed - cast.poured - cast.overflow
    return (
        f"{cast.membrane}: {counted(cast.casts, 'cast')} with {counted(cast.cavities, 'cavity')} for "
        f"{counted(cast.needed, 'membrane')}. Mix {cast.batch_grams:.3g} g ({cast.batch:.3g} ml) a cast{_batch(cast)}. "
        f"A cast takes at least {cast.mixed:.3g} ml ({cast.grams:.3g} g): the cavities hold {cast.poured:.3g} ml, "
        f"{cast.overflow:.3g} ml flow over the rims, and {left:.3g} ml stay in the cup. {_spare_words(cast)}"
    )


def _batch(cast: Cast) -> str:
    """Reason for the smallest batch; empty for a larger one."""
    return ", the smallest batch whose parts a kitchen scale divides well" if cast.grams < SMALLEST_BATCH else ""


def _spare_words(cast: Cast) -> str:
    """Where spare membranes come from."""
    if cast.spare:
        return f"The casts make {counted(cast.spare, 'spare membrane')}."
    return (
        "No cavity is left for a spare membrane: if one tears, cast once more from a new cup, which the order list "
        "includes."
    )


def cure_words(design: ArrayDesign) -> str:
    """Silicone of a design with its pot life and its cure; empty if the catalogue lacks it."""
    silicone = catalogue().silicone(design).part
    if not isinstance(silicone, Silicone):
        return ""
    return (
        f"{silicone.name}: work within {silicone.pot_life:g} min, cure {silicone.cure_time:g} h at 23 \N{DEGREE SIGN}C."
        " Mix the two parts as the package says."
    )


def opening_words(cast: Cast) -> str:
    """How to open the mold and how to push the membranes out."""
    if not cast.closed:
        start = "The cavities lie open."
    else:
        start = (
            "Put a flat blade, 5 to 8 mm wide and at most 2 mm thick, into a slot between base and lid and turn it. "
            "The blade stands on the base and lifts the lid, which turns about its opposite edge. Repeat in the slot "
            f"on that side. The lid is held by {cast.opening.suction:.0f} N at most, if no air gets below it, so the "
            f"blade lifts with at most {cast.opening.blade:.0f} N. The slot then bears a bending stress of "
            f"{cast.opening.roof_stress:.0f} MPa."
        )
    if cast.ejector is None:
        return f"{start} The cavities are blind, so lift each membrane at its edge with tweezers."
    place = "under the rim, which is glued and does not vibrate" if cast.ejector.on_rim else "in the middle"
    return (
        f"{start} Pull the plate with the plugs off the base. Push each membrane out from below with a blunt rod of "
        f"{2 * cast.ejector.radius:.1f} mm or less, through the {counted(len(cast.ejector.spots), 'hole')} {place}. "
        "Cut off the thin sleeve of silicone that a plug leaves."
    )


def closing_words(cast: Cast) -> str:
    """How high to fill the mold and how to close it."""
    filled = f"Fill the cavities {OVERFILL:g} mm above their rims."
    if not cast.closed:
        return f"{filled} Draw the scraper along its rails once."
    return (
        f"{filled} Slide the lid slowly down on its pins, so that the air leaves through the vents and the gap, and "
        f"put a weight of {CLOSING_FORCE / 10:g} kg on it. Do not clamp the edges: they are {cast.gap:g} mm apart, so "
        f"a clamp bends the lid. After {CLOSING_TIME:g} s the film on the lands is about "
        f"{1000 * cast.film:.1f} um thick, by Stefan's equation at an assumed viscosity of 30 Pa s."
    )


def write_casting(model: ArrayModel, bill: Bill, folder: Path) -> None:
    """Write ``casting.txt`` and ``casting.csv``: volumes of silicone, and how to close and to open the mold."""
    casts = casts_of(model, bill)
    lines = [cure_words(model.design), ""]
    lines += [words for cast in casts for words in (casting_words(cast), closing_words(cast), opening_words(cast), "")]
    write_text(folder / "casting.txt", "\n".join(lines))
    table = io.StringIO()
    writer = csv.writer(table, lineterminator="\n")
    writer.writerow(_COLUMNS)
    for cast in casts:
        volumes = (cast.poured, cast.overflow, cast.mixed - cast.poured - cast.overflow, cast.mixed, cast.grams)
        row = (cast.membrane, cast.needed, cast.cavities, cast.casts)
        others = (cast.wasted, cast.opening.suction if cast.closed else 0.0, cast.batch_grams, cast.batch)
        writer.writerow([*row, *(f"{value:.4g}" for value in (*volumes, *others)), cast.spare])
    write_text(folder / "casting.csv", table.getvalue())
