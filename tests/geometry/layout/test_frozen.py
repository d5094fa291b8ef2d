"""Frozen places: any layout as one of places in space, lengths tube by tube, and the file that holds them."""

import json
import math
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from coarse_cells import coarse_cells
from refusals import check_messages, refused

import acoustic_fem
import geometry
from geometry import Kind
from geometry.design import read_design, save_places, write_design
from geometry.layout import array_size, cutting_list, frozen_values, lay_out
from geometry.layout.overlaps import overlaps
from geometry.plan.frozen import smooth_courses
from geometry.plan.frozen_ways import ways_of
from geometry.plan.routing import path_length, tightest_bend

HERE = Path(__file__).parent
BAND = np.linspace(1, 100, 7)
ARRAY = geometry.prototype("array-2x6")


def frozen(design):
    return design.with_values(frozen_values(design, lay_out(design)))


def level(response):
    return 20 * np.log10(np.abs(response.transfer_function.values))


def difference(design, fidelity, band=BAND):
    one, other = (acoustic_fem.solve(each, band, fidelity=fidelity) for each in (design, frozen(design)))
    return float(np.abs(level(one) - level(other)).max())


@pytest.mark.parametrize("fidelity", ["lumped", "atlas"])
@pytest.mark.parametrize("name", ["array-2x6", "fingertip-3x4", "glove"])
def test_a_frozen_layout_sounds_as_the_layout_that_was_frozen(name, fidelity):
    assert difference(geometry.prototype(name), fidelity) < 1e-12


@pytest.mark.slow
@pytest.mark.parametrize("fidelity", ["helmholtz", "navier-stokes"])
def test_a_frozen_layout_sounds_as_before_in_three_dimensions(fidelity):
    with coarse_cells():
        small = ARRAY.with_values({"lines.0.points": 3, "layout.pitch": 15.0})
        assert difference(small, fidelity, BAND[:2]) < 1e-12


@pytest.mark.parametrize("name", ["array-2x6", "fingertip-3x4", "glove", "large-area-64"])
def test_a_frozen_layout_has_its_parts_where_they_were(name):
    design = geometry.prototype(name)
    layout, other = lay_out(design), frozen(design)
    found = lay_out(other)
    for one, two in zip((*layout.points, *layout.microphones), (*found.points, *found.microphones), strict=True):
        assert layout.frame(one).origin == found.frame(two).origin
        np.testing.assert_allclose(layout.frame(one).axes, found.frame(two).axes, atol=1e-12)
    for one, two in zip(layout.tubes, found.tubes, strict=True):
        np.testing.assert_array_equal(one.course, two.course)
    assert overlaps(other, found) == ()
    assert array_size(other) == pytest.approx(array_size(design), abs=1e-9)
    assert [(cut.cut_length, cut.count) for cut in cutting_list(other)] == [
        (cut.cut_length, cut.count) for cut in cutting_list(design)
    ]


def test_a_wound_layout_is_frozen_on_its_cylinder():
    design = geometry.load_design("docs/examples/wristband-16.toml")
    other = frozen(design)
    assert overlaps(other, lay_out(other)) == ()
    assert difference(design, "lumped") < 1e-12


def test_a_design_with_frozen_places_is_read_as_it_was_written():
    design = frozen(ARRAY)
    assert read_design(write_design(design)) == design


def without_courses(design, **values):
    """The frozen design with tubes that are smooth curves."""
    data = design.model_dump()
    data["layout"]["frozen"]["tubes"] = ()
    return geometry.ArrayDesign.model_validate(data).with_values(values)


@pytest.mark.parametrize("extra", [0.0, 0.02, 0.5, 3.0])
def test_smooth_tubes_have_exactly_their_length_and_leave_along_their_ports(extra):
    design = without_courses(frozen(ARRAY))
    ways = ways_of(design, design.layout.frozen)
    lengths = ways.shortest + extra
    courses = smooth_courses(ways, lengths)
    np.testing.assert_allclose([path_length(course) for course in courses], lengths, rtol=1e-8)
    for course, out, back in zip(courses, *ways.out, strict=True):
        for step, direction in ((course[1] - course[0], out), (course[-2] - course[-1], back)):
            assert step @ direction == pytest.approx(np.linalg.norm(step), rel=1e-12)


def test_a_smooth_tube_between_tilted_shells_is_an_arc():
    radius, turn = 20.0, math.radians(50)
    shell = ARRAY.resonator.outer_diameter / 2
    # Two shells whose tangents meet: between the walls the arc has the radius R - r / tan(turn / 2).
    normal = [[math.sin(a), 0.0, math.cos(a)] for a in (0.0, turn)]
    values = frozen_values(ARRAY, lay_out(ARRAY))
    parts = values["layout"]["frozen"]
    floor = radius - ARRAY.resonator.port_axis_height
    for number, z in enumerate(normal):
        parts["points"][number] |= {
            "at": [floor * z[0], 0.0, floor * z[2]], "normal": z, "x": [z[2], 0.0, -z[0]],
            "ports": [180.0, 0.0], "plan": [radius * turn * number, -500.0],
        }  # fmt: skip
    parts["tubes"][1] = {}
    arc = radius - shell / math.tan(turn / 2)
    length = turn * arc + 2 * ARRAY.resonator.wall_thickness
    parts["tubes"][0], parts["tubes"][2] = {}, {}
    values["lines.0.lengths"] = [80.0, length, 80.0, *values["lines.0.lengths"][3:]]
    course = lay_out(ARRAY.with_values(values)).tubes[1].course
    centre = np.array([shell, 0.0, radius - arc])  # below the mouth of the first shell
    np.testing.assert_allclose(np.linalg.norm(course[1:-1] - centre, axis=1), arc, rtol=1e-3)
    assert tightest_bend(course) == pytest.approx(arc, rel=0.02)


# -- lengths ------------------------------------------------------------------------------------------
def test_lengths_that_equal_the_tubes_change_nothing():
    lengths = [ARRAY.microphone_tube.length, *[ARRAY.tube.length] * 11, ARRAY.microphone_tube.length]
    design = ARRAY.with_values({"lines.0.lengths": lengths})
    assert lay_out(design).points == lay_out(ARRAY).points
    one, other = (acoustic_fem.solve(each, BAND, fidelity="lumped") for each in (ARRAY, design))
    np.testing.assert_allclose(other.transfer_function, one.transfer_function, rtol=1e-12)


def test_each_stated_length_is_that_of_its_own_tube():
    lengths = [20.0, *(12.0 + 0.25 * k for k in range(11)), 30.0]
    design = ARRAY.with_values({"layout.columns": 12, "lines.0.lengths": lengths})
    layout = lay_out(design)
    assert [tube.tube.length for tube in layout.tubes] == lengths
    assert [path_length(tube.course) for tube in layout.tubes] == pytest.approx(lengths)
    assert overlaps(design, layout) == ()
    lip = 2 * design.printing.port_lip
    cuts = [cut.cut_length for cut in cutting_list(design) for _ in range(cut.count)]
    assert sorted(cuts) == pytest.approx(sorted(length - lip for length in lengths))


def test_the_acoustics_know_the_length_of_every_tube():
    """By kinds of tubes, which state the same lengths in another way."""
    steps = [12.0, 14.5, 13.0, 12.0, 15.0]
    kinds = {f"t{k}": {**ARRAY.tube.model_dump(), "length": step} for k, step in enumerate(steps)}
    pattern = ARRAY.with_values(
        {"lines.0.points": 6, "tube_kinds": kinds, "lines.0.pattern": {"tubes": list(kinds)}, "layout.columns": 6}
    )
    end = ARRAY.microphone_tube.length
    stated = ARRAY.with_values({"lines.0.points": 6, "lines.0.lengths": [end, *steps, end], "layout.columns": 6})
    one, other = (acoustic_fem.solve(each, BAND, fidelity="lumped") for each in (pattern, stated))
    np.testing.assert_allclose(other.transfer_function, one.transfer_function, rtol=1e-12)


def test_both_microphone_tubes_of_a_ring_may_differ():
    from rings import triangle

    design = triangle()
    line = design.lines[0]
    lengths = [tube.length for tube in design.tubes_of(line)]
    lengths[0] += 6.0
    longer = design.with_values({"lines.0.lengths": lengths})
    layout = lay_out(longer)
    assert path_length(layout.tubes[0].course) == pytest.approx(lengths[0])
    assert path_length(layout.tubes[line.points].course) == pytest.approx(lengths[-1])


# -- the file -----------------------------------------------------------------------------------------
def saved(folder, **changes):
    """A design file that names its places, and the file of these."""
    design = frozen(ARRAY)
    save_places(design, folder / "a.places.json")
    text = write_design(ARRAY).split("[layout]")[0] + "[layout]\nkind = 'surface'\nplaces = 'a.places.json'\n"
    path = folder / "a.toml"
    path.write_text(text, encoding="utf-8")
    if changes:
        file = folder / "a.places.json"
        file.write_text(json.dumps({**json.loads(file.read_text(encoding="utf-8")), **changes}), encoding="utf-8")
    return path


def test_a_design_file_names_the_file_of_its_places(tmp_path):
    design = geometry.load_design(saved(tmp_path))
    assert design.lines == frozen(ARRAY).lines
    assert lay_out(design).points == lay_out(frozen(ARRAY)).points
    assert read_design(write_design(design)) == design
    text = (tmp_path / "a.places.json").read_text(encoding="utf-8")
    save_places(design, tmp_path / "a.places.json")
    assert (tmp_path / "a.places.json").read_text(encoding="utf-8") == text


def test_a_design_with_frozen_places_takes_changes_of_what_is_inside(tmp_path):
    design = geometry.load_design(saved(tmp_path))
    assert design.with_values({"membrane.thickness": 0.5, "tube.inner_diameter": 0.5}).layout == design.layout


OUTSIDE = {
    "resonator.cavity_diameter": 6.5,
    "resonator.wall_thickness": 2.5,
    "microphone.chamber_diameter": 3.2,
    "layout.pitch": 20.0,
}


@pytest.mark.parametrize("field", OUTSIDE)
def test_sizes_for_which_the_places_were_not_made_are_refused(tmp_path, field):
    design = geometry.load_design(saved(tmp_path))
    values = {field: OUTSIDE[field]}
    if field == "resonator.wall_thickness":
        values["membrane.rim_width"] = design.membrane.rim_width
    with refused(Kind.CONFLICT, field) as found:
        design.with_values(values)
    assert "fit again" in found.value.remedy


CASES = {
    "a count that differs": lambda d: d.with_values({"lines.0.points": 11}),
    "one length too few": lambda d: d.with_values({"lines.0.lengths": [12.5] * 12}),
    "lengths on a cylinder": lambda d: ARRAY.with_values(
        {"layout.kind": "cylinder", "layout.diameter": 80.0, "lines.0.lengths": [12.5] * 13}
    ),
    "a length within the walls": lambda d: ARRAY.with_values({"lines.0.lengths": [12.5] * 6 + [1.0] + [12.5] * 6}),
    "places of another kind": lambda d: d.with_values({"layout.kind": "serpentine"}),
    "no places": lambda d: ARRAY.with_values({"layout": {"kind": "surface"}}),
    "one port too few": lambda d: d.with_values({"layout.frozen.points.2.ports": [0.0]}),
    "no normal": lambda d: d.with_values({"layout.frozen.points.2.normal": [0.0, 0.0, 0.0]}),
    "a direction along the normal": lambda d: d.with_values({"layout.frozen.points.2.x": [0.0, 0.0, 2.0]}),
    "two parts at one place": lambda d: d.with_values({"layout.frozen.points.2.plan": [18.5, 0.0]}),
    "a course of another length": lambda d: d.with_values({"lines.0.lengths": [13.5] * 13}),
    "a tube too short": lambda d: without_courses(d, **{"lines.0.lengths": [12.5] * 5 + [10.0] + [12.5] * 7}),
    "a text in no folder": lambda d: read_design("name = 'a'\n[layout]\nplaces = 'b.json'\n"),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_places_that_do_not_go_with_the_design_are_refused(case):
    with pytest.raises(geometry.DesignError) as found:
        CASES[case](frozen(ARRAY))
    assert found.value.kind in (Kind.CONFLICT, Kind.MISSING, Kind.UNSUITABLE, Kind.OUT_OF_RANGE)


def bad_file(text):
    def call(folder):
        path = saved(folder)
        (folder / "a.places.json").write_text(text, encoding="utf-8")
        geometry.load_design(path)

    return call


FILES = {
    "not JSON": bad_file("places"),
    "not a table": bad_file("[]"),
    "no parts": bad_file('{"lines": []}'),
    "lines of another kind": bad_file('{"lines": [4]}'),
    "another count of lines": lambda folder: geometry.load_design(saved(folder, lines=[])),
    "a place that is a text": lambda folder: geometry.load_design(saved(folder, points=[{"at": "here"}])),
}


def test_messages(tmp_path):
    cases = {name: partial(case, frozen(ARRAY)) for name, case in CASES.items()}
    cases |= {name: partial(case, tmp_path) for name, case in FILES.items()}
    check_messages(HERE / "messages_of_frozen.txt", cases, hidden={f"{tmp_path}/": ""})
