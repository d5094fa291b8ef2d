"""Virtual rigs with all effects of a bench at once: ``python -m benchmarks.whole_bench --write`` writes two tables.

Each rig of array-2x6 has the usual scatter and, beside it, air 12 K warmer than when it was sealed, strained and glued
membranes, voltages of microphones with their high-pass and overload, and membranes that obey the law of large presses.
The first table has the fit to recordings of four points, as ``calibrate`` makes it: for the design, and for the design
in the air of the bench, as ``Library.in_air`` states it. The second has touches of all points in turn by the decoder of
a sensor that nobody calibrated: taps, and presses of 0.5 N, of a sensor that lies still, and of one on a waved hand
with an accelerometer, whose part is taken out of the signals. A rig whose membranes bulge beyond the range of the law
cannot be computed, and is left out with a line that says so. The decoder has either its usual hypotheses, or those of a
sealed sensor. Half an hour of one core; ``--touches`` makes the second table alone. ``--causes`` prints a table of what
the touches lose by each effect: it is left out on rigs of other seeds, that lie still.
"""

from __future__ import annotations

import argparse
import tempfile
import warnings
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TypedDict

import numpy as np
from numpy.typing import NDArray

import acoustic_fem
import localize
from acoustic_fem import Library
from acoustic_fem.calibration.fitted_model import UpdatedModel
from acoustic_fem.calibration.manifest import read_manifest
from acoustic_fem.calibration.measured_library import calibrate
from acoustic_fem.calibration.model_updating import update
from acoustic_fem.quantities.checks import frequency_grid
from acoustic_fem.quantities.microphone_signals import Output
from acoustic_fem.quantities.model_limit_warning import ModelLimitWarning
from acoustic_fem.scatter.tolerances import tolerances_of
from geometry import prototype
from geometry.ground.refusal import Refusal
from geometry.ground.typed import Array
from geometry.ground.whole_files import replace_section
from localize.contacts import Contact, ContactRecorder
from localize.contacts.contact import surface_of
from localize.decoders.decoder_options import TolerantOptions
from localize.decoders.tolerant import TolerantDecoder
from localize.live.touches import touches_of
from localize.signals.array_response import UncoveredWarning
from localize.signals.motion import without_motion
from studies.output.frequencies import CALIBRATION_FREQUENCIES
from studies.test_rig.priors import fit_priors
from studies.test_rig.rig_contacts import made_response
from studies.test_rig.rig_motion import motion_of_rig, waved_hand
from studies.test_rig.virtual_rig import HiddenScatter, Recorder, Rig

PAGE = Path(__file__).parents[1] / "docs" / "evidence" / "calibration.md"
BEGIN, END = "<!-- whole bench: made by benchmarks/whole_bench.py -->", "<!-- end of whole bench -->"
TOUCHED = "<!-- touches of the bench: made by benchmarks/whole_bench.py -->", "<!-- end of touches of the bench -->"
DESIGN, FIRST, SENSORS = "array-2x6", 97000, 15
SCATTER = HiddenScatter(warming=12.0, prestrain=0.0026, glue=0.1)
POINTS = (1, 4, 8, 12)
"""Points whose recordings calibrate a sensor."""
TOUCHES = {"taps of 3 mN": (3e-3, 0.9, 0.04, 0.02, 0.3), "presses of 0.5 N": (0.5, 2.0, 1.0, 0.15, 1.3)}
"""Force (N), time from one touch to the next, length and rise of a touch, and time after its begin within which it must
be reported (s). A press overloads the microphones while it rises, so it may be reported while it lasts or ends."""
CAUSES_FIRST, CAUSES_SENSORS = 96000, 8
_CALM: dict[str, float] = {"warming": 0.0, "prestrain": 0.0, "glue": 0.0}
CAUSES: dict[str, Effects] = {
    "nothing": {},
    "overload": {"overload": 2000.0},
    "overload and high-pass": {"output": "pressure"},
    "law of large presses": {"linear": True},
    "law of large presses, and overload": {"linear": True, "overload": 2000.0},
    "warming by 12 K": {"scatter": {"warming": 0.0}},
    "strain of 0.0026": {"scatter": {"prestrain": 0.0}},
    "glue of 0.1 mm": {"scatter": {"glue": 0.0}},
    "warming, strain and glue": {"scatter": _CALM},
    "all of these": {"scatter": _CALM, "linear": True, "output": "pressure"},
}
"""What a bench lacks, and how."""
WAVED = 5.0
FIRST_TOUCH = 1.0
"""Time of the first touch, s."""
RECORDER = Recorder(seconds=30.0)
LOUD = Recorder(bits=24, full_scale=200.0)
"""Recorder of the touches: its full scale is above the overload of the microphones."""
TOP = 100.0
"""Highest frequency at which transfer functions are compared, Hz."""
FREQUENCY = np.concatenate([[0.5], np.arange(1.0, 501.0)])


class Effects(TypedDict, total=False):
    """Effects of a bench that differ from its usual ones."""

    overload: float
    """Overload of the microphones, Pa."""
    output: Output
    """Signals of the recordings; pressures have neither a high-pass nor an overload."""
    linear: bool
    """True if presses of any force obey the linear law."""
    scatter: dict[str, float]
    """Fields of the hidden scatter."""


@dataclass(frozen=True)
class FittedRig:
    """Fit to recordings of four points of a rig."""

    accepted: bool
    """True if the fit has no objection and no recording was left out."""
    measured: float
    """Largest deviation of a measured point, rms over 1 to 100 Hz and the microphones, as a fraction."""
    others: float
    """The same of the other points, whose transfer functions the fit computes; of a rejected fit too."""


def fitted(rig: Rig, libraries: list[Library]) -> list[FittedRig]:
    """Fits of designs to recordings of four points of a rig, beside its true transfer functions."""
    results = []
    with tempfile.TemporaryDirectory() as folder:
        manifest = read_manifest(rig.record(Path(folder), POINTS, RECORDER))
        for library in libraries:
            found = calibrate(replace(manifest, design=library.design), library)
            priors = fit_priors(library.design, tolerances_of(None))
            fit = update(UpdatedModel(library, priors), found.estimates)
            truth = rig.transfer_function(library.frequency)
            known = [number - 1 for number in found.estimates]
            made = np.array(fit.transfer_function)
            made[known] = [each.transfer_function for each in found.estimates.values()]
            inside = library.frequency <= TOP
            error = np.sqrt((np.abs(made / truth - 1)[..., inside] ** 2).mean((1, 2)))
            good = fit.objection is None and len(known) == len(POINTS)
            results.append(FittedRig(good, float(error[known].max()), float(np.delete(error, known).max())))
    return results


def touched(
    rig: Rig, kind: str, waved: bool, library: Library, linear: bool = False, output: Output = "voltage"
) -> tuple[Array, Array, NDArray[np.int64]]:
    """Signals of the microphones, (n_microphone, n_sample) Pa, times of the touches (s), and their points from 1.

    The hand's part is that of an accelerometer beside the sensor, computed for the design.
    """
    force, apart, length, rise, _ = TOUCHES[kind]
    response = made_response(rig)
    place, radius = surface_of(response)
    random = np.random.default_rng([rig.seed, 31, kind.startswith("presses")])
    points = random.permutation(len(place))
    begin = FIRST_TOUCH + apart * np.arange(len(points))
    time = np.arange(round(1000 * (begin[-1] + apart))) / 1000
    total, where = np.zeros(len(time)), np.zeros((len(time), 2))
    for at, point in zip(begin, points, strict=True):
        ramp = np.clip(np.minimum((time - at) / rise, (at + length - time) / rise), 0.0, 1.0)
        total += force * np.sin(np.pi / 2 * ramp) ** 2
        where[time >= at - 0.2] = place[point]
    contact = Contact(time, where, total, float(radius.min()) / 4)
    pressures = ContactRecorder(response, microphone_noise=0.0, linear=linear).take(contact).signals[:, : len(time)]
    moved = waved_hand(len(time) / 1000, np.random.default_rng([rig.seed, 32]), WAVED)
    if waved:
        pressures = pressures + motion_of_rig(rig, moved)
    padded = np.pad(pressures, ((0, 0), (0, 2000)))
    random = np.random.default_rng([rig.seed, 33, waved])
    signals = rig.recorded({}, padded.shape[1], 0, len(time), replace(LOUD, output=output), random, padded)[1:]
    step = LOUD.full_scale / 2 ** (LOUD.bits - 1)
    signals = np.rint(signals / step) * step
    if waved:
        clipped = np.abs(signals) >= 0.97 * rig.design.microphone.overload
        less = without_motion(library, signals, moved, output="voltage")
        signals = np.where(clipped, signals, less)
    return np.asarray(signals), np.asarray(begin, np.float64), points + 1


def touch_fractions(
    model: localize.Model, late: float, signals: Array, begin: Array, points: NDArray[np.int64]
) -> tuple[float, float, int]:
    """Fractions of the touches that are reported and whose first report is at their point, and number of other reports.

    A touch is reported if a report begins at most so late after it, s.
    """
    found = touches_of(model.stream().push(signals), model.locator)
    near = [[each for each in found if -0.05 <= each.start - at <= late] for at in begin]
    right = np.mean([bool(each) and each[0].point == point for each, point in zip(near, points, strict=True)])
    return float(np.mean([bool(each) for each in near])), float(right), len(found) - sum(map(len, near))


def main() -> None:
    """Print both tables, and write them to the page."""
    for repeated in (ModelLimitWarning, UncoveredWarning):  # by every rig
        warnings.simplefilter("once", repeated)
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--sensors", type=int, default=SENSORS)
    parser.add_argument("--write", action="store_true", help="replace the tables of the page")
    parser.add_argument("--touches", action="store_true", help="make the table of the touches alone")
    parser.add_argument("--causes", action="store_true", help="make the table of causes alone")
    given = parser.parse_args()
    if given.causes:
        print_causes()
        return
    design = prototype(DESIGN)
    libraries = list[Library]()
    if not given.touches:
        nominal = acoustic_fem.solve(design, frequency_grid(CALIBRATION_FREQUENCIES))
        warm = design.air.temperature + SCATTER.warming
        libraries = [nominal, nominal.in_air(temperature_c=warm, hours=SCATTER.hours)]
    library = acoustic_fem.solve(design, FREQUENCY, "lumped")
    sealed = TolerantDecoder(library, options=TolerantOptions.sealed())
    models = {
        "usual": localize.open_model(library, microphone_output="voltage"),
        "sealed": localize.open_model(sealed, library=library, microphone_output="voltage"),
    }
    fits, rows = list[list[FittedRig]](), dict[tuple[str, bool, str], list[tuple[float, float, int]]]()
    for number in range(given.sensors):
        try:
            rig = Rig(design, FIRST + number, SCATTER)
        except Refusal as problem:
            print(FIRST + number, "is left out:", problem, flush=True)
            continue
        if libraries:
            fits.append(fitted(rig, libraries))
            print(rig.seed, fits[-1], flush=True)
        for kind in TOUCHES:
            for waved in (False, True):
                signals = touched(rig, kind, waved, library)
                for name, model in models.items():
                    found = touch_fractions(model, TOUCHES[kind][-1], *signals)
                    rows.setdefault((kind, waved, name), []).append(found)
                    print(rig.seed, kind, waved, name, found, flush=True)
    for text, marks in ((table_of_fits(fits), (BEGIN, END)), (table_of_touches(rows), TOUCHED)):
        if text:
            print(text)
            if given.write:
                replace_section(PAGE, *marks, text.splitlines())


def print_causes() -> None:
    """Print what touches of a sensor that lies still lose by each effect."""
    print("| effect that is left out | taps, mean / 5th percentile (%) | presses, mean / 5th percentile (%) |")
    print("|---" * 3 + "|")
    for name, effects in CAUSES.items():
        overload = effects.get("overload")
        design = prototype(DESIGN)
        design = design if overload is None else design.with_values({"microphone.overload": overload})
        library = acoustic_fem.solve(design, FREQUENCY, "lumped")
        output = effects.get("output", "voltage")
        model = localize.open_model(library, microphone_output=output)
        right: dict[str, list[float]] = {kind: [] for kind in TOUCHES}
        for seed in range(CAUSES_FIRST, CAUSES_FIRST + CAUSES_SENSORS):
            rig = Rig(design, seed, replace(SCATTER, **effects.get("scatter", {})))
            for kind, found in right.items():
                signals = touched(rig, kind, False, library, effects.get("linear", False), output)
                found.append(100 * touch_fractions(model, TOUCHES[kind][-1], *signals)[1])
        cells = (f"{np.mean(of):.1f} / {np.percentile(of, 5):.1f}" for of in right.values())
        print(f"| {name} | {' | '.join(cells)} |", flush=True)


def table_of_fits(fits: list[list[FittedRig]]) -> str:
    """Table of the fits as text, empty without any."""
    if not fits:
        return ""
    lines = [f"| library that is fitted | accepted, of {len(fits)} | measured points (%) | other points (%) |"]
    lines.append("|---" * 4 + "|")
    for name, each in zip(("of the design", "in the air of the bench"), zip(*fits, strict=True), strict=True):
        accepted = sum(one.accepted for one in each)
        errors = (100 * np.array([(one.measured, one.others) for one in each])).T
        cells = (f"{np.median(of):.1f} / {of.max():.1f}" for of in errors)
        lines.append(f"| {name} | {accepted} | {' | '.join(cells)} |")
    return "\n".join(lines)


def table_of_touches(rows: dict[tuple[str, bool, str], list[tuple[float, float, int]]]) -> str:
    """Table of the touches as text."""
    at_point = "at their point, mean / 5th percentile (%)"
    lines = [f"| touches | sensor | hypotheses | reported (%) | {at_point} | target (%) | other reports |"]
    lines.append("|---" * 7 + "|")
    for (kind, waved, name), of_rigs in rows.items():
        there, right, other = (100 * np.array([row[k] for row in of_rigs], np.float64) for k in range(3))
        cells = [kind, "waved, accelerometer" if waved else "still", name, f"{there.mean():.1f}"]
        cells += [f"{right.mean():.1f} / {np.percentile(right, 5):.1f}", "98 / 92", f"{other.sum() / 100:.0f}"]
        lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines)


if __name__ == "__main__":
    main()
