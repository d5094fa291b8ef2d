"""The print report: what is measured is true, and verdicts follow the rules."""

import cadquery as cq
import pytest

import geometry
from geometry.measure import hole_diameters, inner_voids, tessellate, thinnest_wall
from geometry.printing import PROCESSES, Rule, print_report


def finding(report, part, rule):
    (found,) = [f for f in report.findings if (f.part, f.rule) == (part, rule)]
    return found


@pytest.fixture(scope="module")
def array():
    design = geometry.prototype("array-2x6").with_values({"printing.port_lip": 0.3, "printing.glue_gap": 0.05})
    return geometry.build_parts(design)


def wall_of(solid):
    return thinnest_wall(tessellate(solid, 0.005))


@pytest.mark.parametrize("wall", [0.15, 0.3, 1.0])
def test_the_wall_of_a_pipe_is_measured(wall):
    pipe = cq.Solid.makeCylinder(3 + wall, 5).cut(cq.Solid.makeCylinder(3, 5))
    assert wall_of(pipe) == pytest.approx(wall, abs=0.006)


def test_the_floor_of_a_cup_is_measured():
    cup = cq.Solid.makeBox(10, 10, 5).cut(cq.Solid.makeBox(8, 8, 5, cq.Vector(1, 1, 0.35)))
    assert wall_of(cup) == pytest.approx(0.35, abs=1e-9)


def test_sides_that_meet_in_an_edge_are_no_thin_wall():
    # A radial hole leaves edges sharper than 90 degrees on the outside of the cylinder.
    pierced = cq.Solid.makeCylinder(3, 6).cut(cq.Solid.makeCylinder(0.5, 8, cq.Vector(-4, 0, 3), cq.Vector(1, 0, 0)))
    # Where the hole's side and the outside are 40 degrees apart: sqrt(3^2 - (3 sin 40)^2) - 0.5.
    assert wall_of(pierced) > 1.79


def test_holes_are_concave_cylinders_only():
    plate = cq.Workplane().box(10, 10, 2).faces(">Z").workplane().pushPoints([(-2, 0), (2, 0)]).hole(0.7)
    rod = plate.union(cq.Workplane().circle(0.1).extrude(5))
    assert hole_diameters(rod.val()) == pytest.approx([0.7, 0.7])


def test_a_closed_void_traps_resin():
    hollow = cq.Workplane(cq.Solid.makeBox(10, 10, 10).cut(cq.Solid.makeBox(4, 4, 4, cq.Vector(3, 3, 3))))
    assert inner_voids(hollow.val()) == 1
    assert finding(print_report({"hollow": hollow}), "hollow", "trapped volumes").verdict == "fail"


def test_a_part_larger_than_the_machine_fails_and_may_be_turned_to_fit():
    long = {"bar": cq.Workplane().box(170, 5, 5)}
    assert finding(print_report(long, "sla-resin"), "bar", "size").verdict == "ok"
    found = finding(print_report(long, "dlp-fine"), "bar", "size")
    assert (found.verdict, found.limit) == ("fail", 100.0)
    assert found.value == pytest.approx(170)


def test_a_rule_warns_between_its_limits():
    rule = Rule(0.2, 0.4, "test")
    assert [rule.verdict(value) for value in (0.19, 0.2, 0.39, 0.4, 5)] == ["fail", "warn", "warn", "ok", "ok"]


def test_shells_of_the_2x6_array_are_measured_on_the_solids(array):
    report = print_report(array, "sla-resin")
    for shell in ("shell-straight", "shell-corner-90"):
        wall, hole = finding(report, shell, "thinnest wall"), finding(report, shell, "narrowest hole")
        # The lip of the ports: 0.3 mm; the bore: 0.44 mm.
        assert wall.value == pytest.approx(0.3, abs=0.002)
        assert hole.value == pytest.approx(0.44, abs=1e-9)
        assert (wall.verdict, wall.limit, hole.verdict, hole.limit) == ("warn", 0.4, "warn", 0.5)
        assert finding(report, shell, "gap around tube").value == 0.05
        assert finding(report, shell, "trapped volumes").value == 0
        assert finding(report, shell, "facets off the surface").verdict == "ok"
    assert all(f.unit == "mm" or f.rule == "trapped volumes" for f in report.findings)
    assert all(f.reason for f in report.findings)


def test_the_fine_process_passes_what_the_coarse_one_questions(array):
    report = print_report(array, "dlp-fine")
    assert finding(report, "shell-straight", "thinnest wall").verdict == "ok"
    assert finding(report, "shell-straight", "narrowest hole").verdict == "ok"


def test_a_fingertip_bore_cannot_be_printed_by_desktop_stereolithography():
    parts = geometry.build_parts(geometry.prototype("fingertip-3x4"))
    name = next(name for name in parts if name.startswith("shell"))
    parts = {name: parts[name]}
    coarse, fine = (finding(print_report(parts, process), name, "narrowest hole") for process in PROCESSES)
    assert coarse.value == fine.value == pytest.approx(0.18)
    assert (coarse.verdict, fine.verdict) == ("fail", "warn")


def test_the_membrane_is_judged_as_a_casting_only(array):
    report = print_report(array)
    assert [(f.rule, f.verdict) for f in report.findings if f.part == "membrane"] == [("cast thickness", "ok")]
    thin = {"membrane": cq.Workplane().circle(3).extrude(0.15)}
    assert finding(print_report(thin), "membrane", "cast thickness").verdict == "warn"


def test_the_worst_finding_is_the_verdict_and_comes_first(array):
    report = print_report({"plate": cq.Workplane().box(10, 10, 0.3).faces(">Z").workplane().hole(0.2)})
    assert report.verdict == "fail"
    assert [(f.rule, f.verdict) for f in report.problems] == [("narrowest hole", "fail"), ("thinnest wall", "warn")]
    assert print_report({"block": cq.Workplane().box(5, 5, 5)}).verdict == "ok"


def test_an_unknown_process_and_no_parts_are_refused(array):
    with pytest.raises(ValueError, match="process = 'fdm' must be one of: sla-resin, dlp-fine"):
        print_report(array, "fdm")
    with pytest.raises(ValueError, match=r"parts = \{\} must not be empty"):
        print_report({})
