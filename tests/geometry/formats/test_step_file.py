"""STEP files of others: the shapes that they hold, or one refusal, whatever they do to the CAD kernel."""

import re
from pathlib import Path

import cadquery as cq
import pytest
from refusals import refused

from geometry import Kind
from geometry.formats import read_step


@pytest.fixture(scope="module")
def step(tmp_path_factory: pytest.TempPathFactory) -> str:
    path = tmp_path_factory.mktemp("step") / "box (inf).step"
    cq.exporters.export(cq.Workplane().box(4, 4, 20), str(path))
    return path.read_text()


@pytest.mark.slow
def test_a_shape_is_read_to_its_last_digit(tmp_path: Path) -> None:
    path = tmp_path / "box (inf).step"
    made = cq.Workplane().box(1 / 3, 4, 20).edges("|Z").fillet(0.1)
    cq.exporters.export(made, str(path))
    (read,) = read_step(path)
    (kernel,) = cq.importers.importStep(str(path)).vals()
    assert isinstance(read, cq.Solid)
    assert read.Volume() == kernel.Volume()
    assert read.Center().toTuple() == kernel.Center().toTuple()


@pytest.mark.slow
def test_all_shapes_of_a_file_are_read(tmp_path: Path) -> None:
    path = tmp_path / "two.step"
    two = cq.Assembly().add(cq.Workplane().box(1, 1, 1)).add(cq.Workplane().box(2, 1, 1), loc=cq.Location((5, 0, 0)))
    two.export(str(path))
    assert sum(shape.Volume() for shape in read_step(path)) == pytest.approx(3)


BAD = {
    "a number that is none": ("-10.", "NaN"),
    "an infinite number": ("-10.", "-INF"),
    "a number without a double": ("-10.", "-1.E999"),
    "a length of 1e300": ("-10.", "-1.E300"),
    "deep parentheses": ("DATA;\n", f"DATA;\n#9999 = X({'(' * 200_000}{')' * 200_000});\n"),
    "no section of data": ("\nDATA;", ""),
    "no shape": (r"(?s)DATA;.*ENDSEC;", "DATA;\nENDSEC;"),
}


@pytest.mark.parametrize("fault", BAD)
@pytest.mark.slow
def test_a_file_that_the_kernel_does_not_survive_is_refused_by_its_name(fault: str, step: str, tmp_path: Path) -> None:
    path = tmp_path / "bad.step"
    old, new = BAD[fault]
    bad = re.sub(old, new, step, count=0 if old == "-10." else 1)
    path.write_text(bad)
    assert bad != step
    with refused(Kind.UNREADABLE, file=path):
        read_step(path)
