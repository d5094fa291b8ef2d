"""Large presses and bulges: ``python -m benchmarks.presses`` writes the tables of docs/evidence/large-presses.md.

The other program's values come from tests/reference/press.json; tests/reference/README.md says what they are.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from acoustic_fem.membrane import (
    FlatPunch,
    Indenter,
    MountedMembrane,
    SoftPatch,
    Sphere,
    bulge,
    design_disc,
    design_membrane,
    design_mounting_ratio,
    press_curve,
    press_limits,
)
from acoustic_fem.membrane.equilibrium import LoadedDisc, Setup
from acoustic_fem.membrane.finite_elasticity import Section
from acoustic_fem.membrane.press_table import solve_press
from geometry import prototype, prototype_names
from geometry.ground.whole_files import replace_section
from tests.support.reference_data import PressedMembrane

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "docs" / "evidence" / "large-presses.md"

DESIGNS = {"array-2x6": 0.3, "fingertip-4x6": 0.03}
"""Designs of the other program, and the largest force on a soft patch that is compared, N."""


def patches() -> Iterator[str]:
    """Volumes under a soft patch."""
    yield "| design | force (N) | volume (mm³) | other program (mm³) | difference (%) | of the linear law |"
    yield "|---|---|---|---|---|---|"
    for name, largest in DESIGNS.items():
        force, volume = PressedMembrane(name).patch(largest)
        curve = press_curve(design_membrane(name), SoftPatch())
        ours, fraction = curve.response(force).volume, curve.volume_fraction(force)
        for each in zip(force, ours, volume, fraction, strict=True):
            yield (
                f"| `{name}` | {each[0]:.3g} | {each[1] * 1e9:.4g} | {each[2] * 1e9:.4g} "
                f"| {100 * (each[1] / each[2] - 1):+.2f} | {each[3]:.3f} |"
            )


def spheres() -> Iterator[str]:
    """Volumes under spheres."""
    yield "| radius (mm) | force (N) | volume (mm³) | other program (mm³) | difference (%) |"
    yield "|---|---|---|---|---|"
    for radius in (1.5e-3, 8e-3):
        force, volume = PressedMembrane("array-2x6").sphere(radius, 0.6)
        ours = press_curve(design_membrane("array-2x6"), Sphere(radius)).response(force).volume
        for each in zip(force, ours, volume, strict=True):
            yield (
                f"| {radius * 1e3:g} | {each[0]:.3g} | {each[1] * 1e9:.4g} | {each[2] * 1e9:.4g} "
                f"| {100 * (each[1] / each[2] - 1):+.2f} |"
            )


def bulges() -> Iterator[str]:
    """Compliances under pressure."""
    yield "| design | pressure (Pa) | V/(p C₀) of a dead load | other program | difference (%) | V/(p C₀) of gas |"
    yield "|---|---|---|---|---|---|"
    for name in DESIGNS:
        pressure, volume = PressedMembrane(name).bulge()
        membrane = design_membrane(name)
        dead, gas = (bulge(membrane, pressure, dead_load=dead).volume / pressure for dead in (True, False))
        other = volume / pressure
        for place, ours, theirs, of_gas in zip(pressure, dead / dead[0], other / other[0], gas / gas[0], strict=True):
            yield (
                f"| `{name}` | {place:g} | {ours:.4f} | {theirs:.4f} | {100 * (ours / theirs - 1):+.2f} "
                f"| {of_gas:.4f} |"
            )


def meshes() -> Iterator[str]:
    """Volumes on finer and finer meshes, array-2x6."""
    yield "| refinement | unknowns | linear law, error (%) | same, order | 0.1 N (mm³) | 0.3 N (mm³) |"
    yield "|---|---|---|---|---|---|"
    membrane, exact = design_membrane("array-2x6"), design_disc("array-2x6")
    shape, unit = membrane.shape(), membrane.youngs_modulus * membrane.radius**2
    error = np.nan
    for refinement in (1, 2, 3, 4):
        disc = LoadedDisc(Section(shape, refinement), Setup("force"))
        linear = disc.linear_answers()[1] * membrane.radius / membrane.youngs_modulus
        before, error = error, 100 * (1 - linear / exact.volume_per_force)
        order = "" if np.isnan(before) else f"{np.log2(before / error):.2f}"
        volumes = ["", ""]
        if refinement < 4:
            table = solve_press(shape, Setup("force"), refinement)
            found = table.at_force("volume", np.array([0.1, 0.3]) / unit) * membrane.radius**3
            volumes = [f"{each * 1e9:.4g}" for each in found]
        yield f"| {refinement} | {disc.size} | {error:.3f} | {order} | {' | '.join(volumes)} |"


def prototypes() -> Iterator[str]:
    """Ranges and fractions of the prototypes; those with the same membrane share rows."""
    forces = np.array([0.003, 0.03, 0.1, 0.3, 1.0])
    head = " | ".join(f"{force:g} N" for force in forces)
    yield f"| designs | indenter | {head} | floor (N) | largest force (N) |"
    yield "|---|---|" + "---|" * (len(forces) + 2)
    alike: dict[MountedMembrane, list[str]] = {}
    for name in prototype_names():
        alike.setdefault(design_membrane(name), []).append(f"`{name}`")
    for membrane, names in alike.items():
        indenters: dict[str, Indenter] = {
            "soft patch": SoftPatch(),
            "flat punch, a/2": FlatPunch(membrane.radius / 2),
            "sphere, 8 mm": Sphere(8e-3),
        }
        for words, indenter in indenters.items():
            curve = press_curve(membrane, indenter)
            cells = [f"{curve.volume_fraction(f):.3f}" if f <= curve.largest_force else "–" for f in forces]
            cells.append(f"{curve.force_at_floor:.3g}" if np.isfinite(curve.force_at_floor) else "–")
            cells.append(f"{curve.largest_force:.3g}")
            yield f"| {', '.join(names)} | {words} | {' | '.join(cells)} |"


def limits() -> Iterator[str]:
    """Limits of the prototypes' membranes."""
    yield (
        "| design | indenter | linear to 10 % (N) | saturates (N) | floor (N) | torn (N) | usable (N) | stretch there |"
    )
    yield "|---|---|---|---|---|---|---|---|"
    for name in ("array-2x6", "fingertip-3x4", "fingertip-4x6", "line-2"):
        for words, indenter in (("soft patch", SoftPatch()), ("sphere, 8 mm", Sphere(8e-3))):
            found = press_limits(name, indenter)
            forces = found.linear_force, found.saturation_force, found.force_at_floor, found.tear_force
            cells = [f"{force:.2g}" if np.isfinite(force) else "–" for force in (*forces, found.usable_force)]
            yield f"| `{name}` | {words} | {' | '.join(cells)} | {found.stretch:.2f} |"


def mountings() -> Iterator[str]:
    """Changes of the compliance by strain and glue."""
    mounted: dict[str, dict[str, float]] = {
        "strain 0.001": {"membrane.prestrain": 0.001},
        "cooled by 12 K": {"membrane.gluing_temperature": 32.0},
        "glued at 60 °C": {"membrane.gluing_temperature": 60.0},
        "warmed by 12 K": {"membrane.gluing_temperature": 8.0},
        "0.1 mm of silicone glue": {"membrane.glue_thickness": 0.1},
    }
    yield f"| design | {' | '.join(mounted)} |"
    yield "|---|---|---|---|---|---|"
    yield "| `array-2x6`, audit | -4.1 | -9.9 | -27 | – | +8.6 |"
    for name in ("array-2x6", "fingertip-3x4", "fingertip-4x6", "line-2"):
        ratios = [design_mounting_ratio(prototype(name).with_values(values)) for values in mounted.values()]
        yield f"| `{name}` | {' | '.join(f'{100 * (ratio - 1):+.1f}' for ratio in ratios)} |"


def main() -> None:
    """Write and print the tables."""
    for name, lines in {
        "patches": patches(),
        "spheres": spheres(),
        "bulges": bulges(),
        "meshes": meshes(),
        "prototypes": prototypes(),
        "limits": limits(),
        "mountings": mountings(),
    }.items():
        table = ["", *lines, ""]
        print("\n".join(table), flush=True)
        replace_section(PAGE, f"<!-- {name}: made by benchmarks/presses.py -->", f"<!-- end {name} -->", table)


if __name__ == "__main__":
    main()
