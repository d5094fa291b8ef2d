"""Arrays fitted to bodies and carved into them, against the rules of ``docs/robot.md``.

``python -m benchmarks.fitted_bodies F1.stl F2.stl --write`` writes the tables. The two meshes are phalanges of the
Shadow Hand from the package gymnasium-robotics, and carry the parts of the prototype fingertip-3x4. Ten minutes or so
of one core.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

import geometry
from geometry.assembly.model import array_model
from geometry.body.reading import Body, read_body
from geometry.carving import carve
from geometry.ground.refusal import Refusal
from geometry.ground.whole_files import replace_section
from geometry.layout import lay_out
from geometry.layout.overlaps import overlaps
from geometry.plan.routing import tightest_bend
from geometry.schema.ports import least_angle
from geometry.surface import FittedSurface, fit_surface
from geometry.surface.spread import arc_length
from tests.support.bodies import BODIES, FINE, cases, design_of, written

PAGE = Path(__file__).parents[1] / "docs" / "evidence" / "bodies.md"
#: Sections of the page.
FITS = ("<!-- fits: made by benchmarks/fitted_bodies.py -->", "<!-- end fits -->")
EQUAL = ("<!-- equal: made by benchmarks/fitted_bodies.py -->", "<!-- end equal -->")
CARVED = ("<!-- carved: made by benchmarks/fitted_bodies.py -->", "<!-- end carved -->")
#: What further bodies carry, by the names of their files: the table [surface] without the body.
MESHES: dict[str, dict[str, Any]] = {
    "F1.stl": {"pitch": 4.0, "skin": 1, "region": {"normal": {"towards": (0, -1, 0), "within": 100}}},
    "F2.stl": {"pitch": 4.5, "skin": 1},
}
#: Pitch at which further bodies carry equal tubes, mm: at that above some steps cannot become as long as the others.
EQUAL_PITCH = {"F1.stl": 5.0, "F2.stl": 6.0}
#: Layouts that are timed; the quickest counts.
_LAYOUTS = 20


def bodies(files: list[str], folder: Path) -> Iterator[tuple[str, geometry.ArrayDesign, Body]]:
    """Name, design and body of each case."""
    for name, (parts, names, stated) in cases().items():
        body = name.split()[0]
        yield name, design_of(parts, names, stated), read_body(written(BODIES[body](), folder / f"{body}.step"))
    for file in files:
        path = Path(file)
        yield path.name, design_of(FINE, "AB", MESHES[path.name]), read_body(path, skin=1)


def fit_row(name: str, found: FittedSurface, seconds: float) -> str:
    """Row of the table of fits."""
    design, layout = found.design, lay_out(found.design)
    assert design.layout.frozen is not None
    laid = 1e3 * min(_timed(design) for _ in range(_LAYOUTS))
    bend = min(tightest_bend(tube.course) / tube.tube.smallest_bend_radius for tube in layout.tubes)
    angle = min(least_angle(point.port_angles) for point in layout.points)
    cells = (
        f"{design.point_count}",
        f"{len(overlaps(design, layout))}",
        f"{design.layout.frozen.seed + 1}",
        f"{found.spacing[1]:.3f}",
        f"{bend:.2f}",
        f"{angle:.0f}",
        f"{found.shell_kinds}",
        f"{found.rim_gap:.2f}",
        f"{seconds:.1f}",
        f"{laid:.1f}",
    )
    return f"| {name} | {' | '.join(cells)} |"


def equal_row(name: str, found: FittedSurface, seconds: float) -> str:
    """Row of the table of fits with equal tubes."""
    design, layout = found.design, lay_out(found.design)
    frames = [layout.frame(point) for point in layout.points]
    normals = np.array([frame.axes[2] for frame in frames])
    places = np.array([frame.origin for frame in frames]) + design.resonator.port_axis_height * normals
    steps = [k for k in range(len(places) - 1) if layout.points[k].line == layout.points[k + 1].line]
    step = np.array([arc_length(places[k], normals[k], places[k + 1], normals[k + 1]) for k in steps])
    inner = {tube.tube.length for tube in layout.tubes if 0 < tube.segment < design.lines[tube.line].points}
    bend = min(tightest_bend(tube.course) / tube.tube.smallest_bend_radius for tube in layout.tubes)
    cells = (
        f"{design.point_count}",
        f"{len(overlaps(design, layout))}",
        f"{100 * step.std() / step.mean():.2f}",
        ", ".join(f"{length:g}" for length in sorted(inner)),
        f"{found.spacing[1]:.3f}",
        f"{bend:.2f}",
        f"{seconds:.1f}",
    )
    return f"| {name} | {' | '.join(cells)} |"


def _timed(design: geometry.ArrayDesign) -> float:
    """Processor time of one layout, s."""
    start = time.process_time()
    lay_out(design)
    return time.process_time() - start


def carved_row(name: str, design: geometry.ArrayDesign, body: Body) -> str:
    """Row of the table of carved bodies."""
    model = array_model(design)
    start = time.process_time()
    found = carve(model, body)
    seconds = time.process_time() - start
    first, template = found.bodies
    cells = (
        f"{first.name}",
        f"{first.openings}, {template.openings}",
        f"{max(abs(each.balance) for each in found.bodies):.0e}",
        f"{found.worst_clash[1]:.1e}",
        f"{found.thinnest:.2f}",
        f"{seconds:.1f}",
    )
    return f"| {name} | {' | '.join(cells)} |"


def main() -> None:
    """Print the rows of all tables, and write the tables to the page."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("meshes", nargs="*", help=f"files of further bodies, called {' and '.join(MESHES)}")
    parser.add_argument("--write", action="store_true", help="replace the tables of the page")
    given = parser.parse_args()
    fits = [
        "| body | points | overlaps | seeds tried | scatter of the spacing (CV) | tightest bend / "
        "smallest allowed | smallest angle of ports (degrees) | kinds of shells | gap under a rim (mm) | fit (s) | "
        "layout (ms) |",
        "|---|---|---|---|---|---|---|---|---|---|---|",
    ]
    carved = [
        "| body | solid | openings through it, through the template | error of the volume | largest volume that a "
        "part shares with the wall (mm³) | thinnest wall (mm) | carving (s) |",
        "|---|---|---|---|---|---|---|",
    ]
    equal = [
        "| body | points | overlaps | scatter of the steps (CV, %) | length of the tubes between points (mm) | scatter "
        "of the spacing (CV) | tightest bend / smallest allowed | fit (s) |",
        "|---|---|---|---|---|---|---|---|",
    ]
    with tempfile.TemporaryDirectory() as folder:
        for name, design, body in bodies(given.meshes, Path(folder)):
            try:
                start = time.process_time()
                found = fit_surface(design, body)
                fits.append(fit_row(name, found, time.process_time() - start))
                print(fits[-1], flush=True)
                assert design.surface is not None
                pitch = EQUAL_PITCH.get(name, design.surface.pitch)
                start = time.process_time()
                alike = fit_surface(design.with_values({"surface.tubes": "equal", "surface.pitch": pitch}), body)
                own = f"{name}, pitch of {pitch:g} mm" if name in EQUAL_PITCH else name
                equal.append(equal_row(own, alike, time.process_time() - start))
                print(equal[-1], flush=True)
                carved.append(carved_row(name, found.design, body))
                print(carved[-1], flush=True)
            except Refusal as error:
                print(f"{name}: {error}", flush=True)
    if given.write:
        replace_section(PAGE, *FITS, fits)
        replace_section(PAGE, *EQUAL, equal)
        replace_section(PAGE, *CARVED, carved)


if __name__ == "__main__":
    main()
