"""Enclosed air: ``python -m benchmarks.enclosed_air`` writes the tables of docs/evidence/large-presses.md.

Two options print without writing: ``--sensors 2`` is a quick trial, and ``--design line-2`` has the decoders of another
prototype. Sensors are virtual rigs at ``lumped`` fidelity whose seeds begin at ``FIRST``. Touches are multi-sines with
1 mPa of noise, from the library's own generator.
"""

from __future__ import annotations

import argparse
import warnings
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np

import acoustic_fem
import geometry
import localize
from acoustic_fem import LocalAir
from acoustic_fem.enclosed import SealedSensor, enclosed_air, suggested_vent
from acoustic_fem.library.transfer_functions import Library, measured_library
from acoustic_fem.quantities.medium import GAS_CONSTANT
from geometry.ground.whole_files import replace_section
from localize.decoders.decoder_options import TolerantOptions
from localize.signals.array_response import response_of
from studies.test_rig import HiddenScatter, Rig

PAGE = Path(__file__).parents[1] / "docs" / "evidence" / "large-presses.md"
PROTOTYPES = ("array-2x6", "fingertip-3x4", "fingertip-4x6", "glove", "line-2")
GRID, NOISE = np.arange(1.0, 131.0, 3.0), 1e-3
FIRST, SENSORS, TOUCHES = 9700, 12, 5
#: Touches before those that are counted where a drift is followed.
SETTLED = 9
STATES = {
    "at rest": HiddenScatter(),
    "worn, +12 K": HiddenScatter(warming=12.0, hours=0.0),
    "worn and sweating": HiddenScatter(warming=12.0, humidity=0.85),
    "climb of 1000 m": HiddenScatter(climb=1000.0, hours=0.0),
}


def states() -> Iterator[str]:
    """Pressures and compliances of the prototypes."""
    yield (
        "| design | 1 K (Pa) | +12 K (Pa) | C (%) | and sweat (Pa) | C (%) | 1000 m (Pa) | C (%) | lasts (h) "
        "| vent (mm) |"
    )
    yield "|---|---|---|---|---|---|---|---|---|---|"
    for name in PROTOTYPES:
        found = [
            enclosed_air(name, air, hours=hours)
            for air, hours in (
                (LocalAir(temperature_c=21.0), 0.0),
                (LocalAir(temperature_c=32.0), 0.0),
                (LocalAir(temperature_c=32.0, humidity=0.85), 0.25),
                (LocalAir(altitude=1000.0), 0.0),
            )
        ]
        sensor, vent = SealedSensor.of(name), suggested_vent(name)
        hours = sensor.time_constant(101325.0, sensor.permeance("air") * GAS_CONSTANT * 293.15 / 101325.0) / 3600
        cells = [f"{found[0].overpressure:.0f}"]
        for each in found[1:]:
            cells += [f"{each.overpressure:.0f}", f"{100 * (each.compliance_ratio - 1):+.0f}"]
        yield f"| `{name}` | {' | '.join(cells)} | {hours:.1f} | {vent.diameter:.3f} x {vent.length:g} |"


def decoders(name: str, sensors: int) -> Iterator[str]:
    """Accuracy of decoders on sensors whose enclosed air is not at rest."""
    yield "| state | design's library | tolerance-aware | same, `sealed()` | calibrated | same, drift followed |"
    yield "|---|---|---|---|---|---|"
    nominal = acoustic_fem.solve(geometry.prototype(name), GRID, "lumped")
    plain = localize.BayesDecoder(nominal, NOISE)
    tolerant, sealed = (
        localize.TolerantDecoder(nominal, microphone_noise=NOISE, options=options)
        for options in (TolerantOptions(), TolerantOptions.sealed())
    )
    right: dict[str, list[list[float]]] = {state: [] for state in STATES}
    for seed in range(FIRST, FIRST + sensors):
        known = _calibrated(nominal, seed)
        fixed, following = localize.BayesDecoder(known, NOISE), localize.DriftDecoder(known, NOISE)
        for state, scatter in STATES.items():
            frames, points = _touches(nominal, seed, scatter)
            followed, _ = following.follow(frames, following.start)
            each = [decoder.locate(frames) for decoder in (plain, tolerant, sealed, fixed)]
            right[state].append([100 * float((p.argmax(1) == points)[SETTLED:].mean()) for p in (*each, followed)])
    for state in STATES:
        table = np.array(right[state])
        cells = [f"{mean:.1f} ({least:.1f})" for mean, least in zip(table.mean(0), table.min(0), strict=True)]
        yield f"| {state} | {' | '.join(cells)} |"


def _calibrated(nominal: Library, seed: int) -> Library:
    h = Rig(nominal.design, seed, HiddenScatter(), "lumped").transfer_function(GRID)
    return measured_library(nominal.design, nominal, h, 0.01 * np.abs(h), ("numpy",), {})


def _touches(nominal: Library, seed: int, scatter: HiddenScatter) -> tuple[np.ndarray, np.ndarray]:
    """Touches of a sensor in a random order: (n, n_microphone, 250) Pa, and points from 0, (n,)."""
    h = Rig(nominal.design, seed, scatter, "lumped").transfer_function(GRID)
    truth = replace(response_of(nominal), transfer_function=h)
    count = TOUCHES * nominal.design.point_count
    made = localize.TouchGenerator(truth, seed, "training", NOISE).samples(0, count)
    order = np.random.default_rng(seed).permutation(count)
    return made.signals[order, :, -250:].double().numpy(), made.point[order].numpy() - 1


def main() -> None:
    """Print the tables, and write them if all sensors were asked for."""
    warnings.filterwarnings("ignore", "entrance loss|membrane: |.*its library ends", UserWarning)
    parser = argparse.ArgumentParser()
    parser.add_argument("--sensors", type=int, default=SENSORS)
    parser.add_argument("--design", choices=PROTOTYPES, default=PROTOTYPES[0])
    chosen = parser.parse_args()
    for name, lines in {"states": states(), "decoders": decoders(chosen.design, chosen.sensors)}.items():
        table = ["", *lines, ""]
        print("\n".join(table), flush=True)
        if (chosen.design, chosen.sensors) == (PROTOTYPES[0], SENSORS):
            replace_section(PAGE, f"<!-- {name}: made by benchmarks/enclosed_air.py -->", f"<!-- end {name} -->", table)


if __name__ == "__main__":
    main()
