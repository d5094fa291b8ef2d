"""Figures, shopping lists and pictures of docs/applications: ``python docs/make_applications.py [NAME ...]``.

Each page is a worked design. Its tables are those of this script: verdict, size, force and cost, the order list
that ``acoustic-fem parts`` writes, and touches on virtual rigs decoded in full. Names are those of the pages; without
a name all pages are computed. The tables are printed; ``--write`` puts them into the pages and draws the pictures,
in about a minute of one core a page.

Rigs have rubber, microphones and air that no decoder is given, see docs/calibration.md#a-virtual-rig. On none of
their seeds was a constant chosen.
"""

from __future__ import annotations

import argparse
import math
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from PIL import Image

import acoustic_fem
import geometry
import localize
import studies
from acoustic_fem.atlas import quick_fidelity
from geometry.assembly.model import ArrayModel, array_model
from geometry.formats.part_files import tessellate_distinct
from geometry.ground.whole_files import replace_section
from geometry.pictures.views import draw_array, exploded_view
from geometry.printing.plates import Plates, export_plates
from geometry.schema.print_processes import PrintProcess, process_of
from localize.contacts import ContactRecorder, pulse_times, pulse_wave
from localize.evaluation import PRESSES, TAPS, TouchedSensors, decide
from localize.signals import ArrayResponse, response_of
from studies.kit.kit_files import order_of
from studies.kit.ordering import OrderLine, OrderList, printed_spares
from studies.output.report_texts import percent
from studies.run import design_quality, draw_quality
from studies.run.quality import predicted_accuracy
from studies.verdict import force_in_words

DOCS = Path(__file__).parent
PAGES, PICTURES, EXAMPLES = DOCS / "applications", DOCS / "images" / "applications", DOCS / "examples"
#: Pages, each with the design file that it works out, below docs/examples; the last works out a prototype.
DESIGNS = {
    "gripper-pad": "gripper-pad.toml",
    "fingertip": "robot/fingertip.toml",
    "wristband": "wristband-10.toml",
    "glove": "glove-10.toml",
    "mat": "floor-mat.toml",
    "pulse-reader": "pulse-reader.toml",
    "first-day": "array-2x6",
}
#: Pages whose sensor reads a pulse, too, and pages that list the prints alone.
PULSE, PRINTS = ("pulse-reader",), ("first-day",)
#: Pages that show the array as a whole, because its parts leave a round body in all directions.
WHOLE = ("wristband", "fingertip")
#: Seeds of the rigs, and touches of each kind at every point of each.
RIGS, TOUCHES = tuple(range(9301, 9309)), 25
#: Accuracies of arrays of more points are predicted, because decoding takes the square of their points.
UP_TO = 36
#: Frequencies of the libraries, Hz, and the last one of a rig, above which its deviations stay what they are there.
GRID, RIG_UP_TO = np.concatenate([[0.5], np.arange(1.0, 160.0), np.arange(160.0, 501.0, 5.0)]), 160.0
KINDS = {"taps": TAPS, "presses": PRESSES}
#: Pulses of each rig: length in s, range of beats per minute, distance in s up to which a wave is found.
SECONDS, BEATS, FOUND = 10.0, (50.0, 100.0), 0.04
#: Size of the array's picture and largest width of both, pixels, and their quality as WebP.
SIZE, WIDTH, QUALITY = (1200, 750), 1000, 80


@dataclass(frozen=True)
class Touched:
    """Top-1 accuracies by kind of touch, fractions of one: a list of one value a sensor."""

    design: dict[str, list[float]]
    """Rigs, decoded with the library of the design."""
    own: dict[str, list[float]]
    """Rigs, each decoded with its own transfer functions, as after an ideal calibration."""
    nominal: dict[str, list[float]]
    """The sensor exactly as designed."""

    def rows(self) -> list[str]:
        """Rows of a table, with the worst sensor in brackets."""
        words = {
            "design": "as built, with the library of the design",
            "own": "as built, with its own library",
            "nominal": "exactly as designed",
        }
        lines = ["| sensor | taps (%) | presses (%) |", "|---|---:|---:|"]
        for name, title in words.items():
            of_kind = getattr(self, name)
            cells = " | ".join(f"{100 * np.mean(of_kind[k]):.1f} ({100 * min(of_kind[k]):.1f})" for k in KINDS)
            lines.append(f"| {title} | {cells} |")
        return lines


class Sensors:
    """A design's library and its rigs.

    Args:
        design: the array.
        seeds: seeds of the rigs.
    """

    def __init__(self, design: geometry.ArrayDesign, seeds: Sequence[int]) -> None:
        self.design, self.seeds = design, tuple(seeds)
        fidelity = "atlas" if quick_fidelity(design, GRID).name == "atlas" else "lumped"
        self.library = acoustic_fem.solve(design, GRID, fidelity=fidelity)
        self.nominal = response_of(self.library)
        self.rigs = [self._rig(studies.Rig(design, seed, fidelity=fidelity)) for seed in self.seeds]

    def _rig(self, rig: studies.Rig) -> ArrayResponse:
        """The response of a rig."""
        h, below = self.nominal.transfer_function, GRID <= RIG_UP_TO
        ratio = rig.transfer_function(GRID[below]) / h[..., below]
        ratio = np.concatenate([ratio, np.repeat(ratio[..., -1:], (~below).sum(), axis=-1)], axis=-1)
        return replace(self.nominal, transfer_function=h * ratio)

    def touched(self, touches: int = TOUCHES) -> Touched:
        """Touches of every point of every rig, decoded from frames of 250 ms."""
        uncalibrated = localize.open_model(self.library).locator
        own = [_accuracy(localize.BayesDecoder(rig, "design"), rig, touches) for rig in self.rigs]
        built = [_accuracy(uncalibrated, rig, touches) for rig in self.rigs]
        nominal = [_accuracy(uncalibrated, self.nominal, touches)]
        return Touched(*({kind: [each[kind] for each in rows] for kind in KINDS} for rows in (built, own, nominal)))

    def pulses(self) -> list[str]:
        """Rows on pulses of a finger on every point of every rig, read with the library of the design."""
        reader = localize.PulseReader(self.nominal, "design")
        rates, waves, located = [], [], []
        for number, rig in enumerate(self.rigs):
            recorder = ContactRecorder(rig, microphone_noise="design", seed=self.seeds[number])
            for point in range(rig.point_count):
                assert rig.position is not None
                sample = number * rig.point_count + point
                rate = float(np.linspace(*BEATS, len(self.rigs) * rig.point_count)[sample])
                place = tuple(rig.position[point])
                take = recorder.take(pulse_wave(place, rate, SECONDS, seed=self.seeds[0], sample=sample), sample)
                found = reader.read(take.signals, point + 1)
                truth = pulse_times(rate, SECONDS, seed=self.seeds[0], sample=sample)
                beats = truth["percussion"][(truth["percussion"] > 1) & (truth["percussion"] < SECONDS - 1)]
                rates.append(found.rate - 60 / np.diff(beats).mean())
                waves += [bool(np.nanmin(np.append(abs(found.waves["percussion"] - t), 9)) < FOUND) for t in beats]
                located.append(reader.read(take.signals).point == point + 1)
        return [
            "| figure | value |",
            "|---|---:|",
            f"| recordings of {SECONDS:g} s | {len(rates)} |",
            f"| recordings in which a pulse is found (%) | {100 * np.mean(np.isfinite(rates)):.1f} |",
            f"| beats found within {1000 * FOUND:.0f} ms (%) | {100 * np.mean(waves):.1f} |",
            f"| rms error of the heart rate (beats per minute) | {np.sqrt(np.nanmean(np.square(rates))):.2f} |",
            f"| largest error of the heart rate (beats per minute) | {np.nanmax(np.abs(rates)):.2f} |",
            f"| point found if you do not give it (%) | {100 * np.mean(located):.1f} |",
        ]


def predicted_rows(design: geometry.ArrayDesign) -> list[str]:
    """Rows of predicted accuracies, with the fifth percentile of the sensors in brackets."""
    found = predicted_accuracy(design)
    assert found is not None
    as_built = " | ".join(f"{100 * each.mean:.1f} ({100 * each.worst:.1f})" for each in (found.taps, found.presses))
    nominal = " | ".join(f"{100 * each.mean:.1f}" for each in (found.nominal.taps, found.nominal.presses))
    return [
        "| sensor | taps (%) | presses (%) |",
        "|---|---:|---:|",
        f"| as built, with the library of the design | {as_built} |",
        f"| exactly as designed | {nominal} |",
    ]


def _accuracy(decoder: localize.Locator, sensor: ArrayResponse, touches: int) -> dict[str, float]:
    touched = TouchedSensors(sensor, "design", seed=77)
    return {name: decide(decoder, touched.touches(kind, touches)).evaluation().top1 for name, kind in KINDS.items()}


@dataclass(frozen=True)
class Made:
    """A design as it would be made."""

    model: ArrayModel
    """The array, put together."""
    process: PrintProcess
    """Printing process of the design."""
    order: OrderList
    """Order list of its kit."""
    plates: Plates
    """Plates of its printed parts."""


def make(design: geometry.ArrayDesign, folder: Path) -> Made:
    """Draw the parts of a design, arrange them on plates in a folder, and list what its kit lists."""
    process = process_of(design.printing)
    model = array_model(design)
    shapes = tessellate_distinct(model.parts)
    plates = export_plates(model.parts, folder, process, shapes, printed_spares(model.parts))
    return Made(model, process, order_of(model, len(plates.plates), process), plates)


def print_rows(made: Made) -> list[str]:
    """Rows of what is printed: a row for each part, in the order of the plates."""
    lines = ["| plate | part | pieces |", "|---|---|---:|"]
    for plate in made.plates.plates:
        lines += [f"| `{plate.path.name}` | {part} | {pieces} |" for part, pieces in plate.copies.items()]
    return lines


def figure_rows(verdict: studies.Verdict, made: Made) -> list[str]:
    """Rows on a design: size, force, cost, hours."""
    design, figures = verdict.design, verdict.figures
    x, y, z = figures.size
    target = design.target
    rows = {
        "verdict": f"{verdict.outcome}{_broken(verdict)}",
        "points": f"{design.point_count}",
        "microphones": f"{len(design.microphones)}",
        "size": f"{x:.0f} x {y:.0f} x {z:.1f} mm",
        "printer": made.process.title,
        "force of the target": f"{target.force:g} N, contact of {target.contact_radius:g} mm radius",
        "smallest force of a tap": force_in_words(figures.smallest_force),
        "taps of the target, as built, predicted": percent(figures.taps),
        "parts of one array": f"{made.order.bill.cost:.2f} USD",
        "with spares": f"{made.order.cost('array'):.2f} USD",
        "molds, used again": f"{made.order.cost('molds'):.2f} USD",
        "all, with tools and whole packs": f"{made.order.cost_of_packs:.0f} USD",
        "hours of work": f"{made.order.hours:.0f}",
        "hours of waiting": f"{made.order.waiting:.0f}",
    }
    return ["| figure | value |", "|---|---|", *(f"| {name} | {value} |" for name, value in rows.items())]


def _broken(verdict: studies.Verdict) -> str:
    words = [verdict.values[rule.name].words for rule in verdict.broken]
    return f" ({'; '.join(words)})" if words else ""


def shopping_rows(made: Made) -> list[str]:
    """Rows of what one array takes, its molds and spares included: a row for each part that is bought."""
    bought: dict[tuple[str, str], list[OrderLine]] = {}
    for line in made.order.lines:
        if line.purpose in ("array", "molds"):
            bought.setdefault((line.bought_as, line.unit), []).append(line)
    lines = ["| part | order | for | cost (USD) |", "|---|---|---|---:|"]
    for (part, unit), of_part in bought.items():
        amount = math.fsum(line.ordered for line in of_part)
        words = f"{amount:.0f}" if unit == "piece" or amount >= 100 else f"{amount:.2g}"
        ordered = f"{words} {'pieces' if unit == 'piece' else unit}"
        uses = ", ".join(dict.fromkeys(_use(line) for line in of_part))
        lines.append(f"| {part} | {ordered} | {uses} | {math.fsum(line.cost for line in of_part):.2f} |")
    return lines


def _use(line: OrderLine) -> str:
    """Use of a line in a word or two: shells, tubes and molds of all kinds are alike to a buyer."""
    if line.purpose == "molds":
        return "molds"
    if line.part is not None and line.part.kind == "microphone":
        return "microphones"
    uses = {"shell-": "shells", "membrane": "membranes", "microphone-housing": "microphone housings"}
    uses |= {"microphone-board": "microphone boards", "spring": "tubes", "sheath": "tubes"}
    return next((use for begin, use in uses.items() if line.item.startswith(begin)), line.item.replace("-", " "))


def draw(name: str, made: Made, folder: Path) -> list[Path]:
    """The array, taken apart or as a whole, and its accuracy by point as ``check`` predicts it."""
    PICTURES.mkdir(parents=True, exist_ok=True)
    design = made.model.design
    quality = design_quality(design)
    assert quality is not None
    plan = draw_quality(design, quality, folder / "plan.png")
    view = draw_array if name in WHOLE else exploded_view
    found = []
    for source, ending in ((view(made.model, folder / "kit.png", SIZE), "kit"), (plan, "points")):
        picture = Image.open(source).convert("RGB")
        picture.thumbnail((WIDTH, WIDTH))
        found.append(PICTURES / f"{name}-{ending}.webp")
        picture.save(found[-1], quality=QUALITY, method=6)
    return found


def sections(name: str, folder: Path, seeds: Sequence[int] = RIGS, *, drawing: bool = False) -> dict[str, list[str]]:
    """Sections of a page by their marks.

    Args:
        name: name of the page.
        folder: folder for the plates and for pictures as they are drawn.
        seeds: seeds of the rigs.
        drawing: draw the pictures of the page, too.
    """
    path = EXAMPLES / DESIGNS[name]
    design = geometry.load_design(path) if path.suffix else geometry.prototype(path.name)
    made = make(design, folder)
    if name in PRINTS:
        return {"prints": print_rows(made)}
    if drawing:
        draw(name, made, folder)
    found = {"figures": figure_rows(studies.Verdict(design), made), "shopping": shopping_rows(made)}
    if design.point_count > UP_TO:
        return {**found, "accuracy": predicted_rows(design)}
    sensors = Sensors(design, seeds)
    found["accuracy"] = sensors.touched().rows()
    if name in PULSE:
        found["pulse"] = sensors.pulses()
    return found


def marks(section: str) -> tuple[str, str]:
    """Comments between which a section stands."""
    return f"<!-- {section}: made by docs/make_applications.py -->", f"<!-- end {section} -->"


def main() -> None:
    """Print the sections, or write them."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"of {', '.join(DESIGNS)}; by default all")
    parser.add_argument("--write", action="store_true", help="write the tables and the pictures of the pages")
    asked = parser.parse_args()
    if unknown := set(asked.names) - set(DESIGNS):
        parser.error(f"{', '.join(sorted(unknown))}: must be of {', '.join(DESIGNS)}")
    for name in asked.names or DESIGNS:
        with tempfile.TemporaryDirectory() as folder:
            for section, lines in sections(name, Path(folder), drawing=asked.write).items():
                print("\n".join([f"{name}, {section}", *lines, ""]), flush=True)
                if asked.write:
                    replace_section(PAGES / f"{name}.md", *marks(section), lines)


if __name__ == "__main__":
    main()
