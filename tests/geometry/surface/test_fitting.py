"""An array laid on a body: even places, lines that do not cross, few kinds of shells, and nothing that overlaps."""

import itertools
import shutil
from functools import partial
from pathlib import Path

import bodies
import numpy as np
import pytest
from bodies import FINE, PAD, cases, design_of, half, wishes
from refusals import check_messages, refused

import geometry
from geometry import Kind
from geometry.body import read_body
from geometry.design.frozen_rules import inputs_of
from geometry.layout import array_size, lay_out
from geometry.layout.overlaps import overlaps
from geometry.plan.routing import path_length, tightest_bend
from geometry.schema.ports import least_angle
from geometry.schema.surface_fields import SurfaceFit
from geometry.surface import fit_design, fit_surface
from geometry.surface.fit_file import open_design, read_fit, save_fitted
from geometry.surface.order import Order, crossings, steps_of
from geometry.surface.spread import arc_length, nearest_spacing
from geometry.surface.tubes import rounded_ports
from geometry.surface.unrolled import unrolled

HERE = Path(__file__).parent
EXAMPLE = Path("docs/examples/robot")


def fitted(case, folder):
    parts, names, stated = cases()[case]
    body = read_body(bodies.written(bodies.BODIES[case.split()[0]](), folder / "body.step"))
    return fit_surface(design_of(parts, names, stated), body)


def check_fit(found):
    """What every array on a body must be."""
    design, layout = found.design, lay_out(found.design)
    assert overlaps(design, layout) == ()
    assert found.spacing[1] <= 0.08
    assert found.shell_kinds <= 12
    assert found.rim_gap <= 0.8
    for tube in layout.tubes:
        assert tightest_bend(tube.course) >= tube.tube.smallest_bend_radius * (1 - 1e-6)
        assert path_length(tube.course) == pytest.approx(tube.tube.length, rel=1e-6)
    for point in layout.points:
        assert least_angle(point.port_angles) >= 45 - 1e-9
    steps = [(place, place + 1) for place in range(design.point_count - 1)]
    steps = [s for s, (a, b) in zip(steps, itertools.pairwise(layout.points), strict=True) if a.line == b.line]
    frames = [layout.frame(point) for point in layout.points]
    places, normals = (np.array(column) for column in zip(*[(f.origin, f.axes[2]) for f in frames], strict=True))
    assert crossings(steps, places, normals) == []


@pytest.mark.parametrize(
    "case", ["palm", *(pytest.param(each, marks=pytest.mark.slow) for each in ("capsule in pockets", "panel"))]
)
def test_equal_tubes_have_one_length_and_equal_steps(case, tmp_path):
    parts, names, stated = cases()[case]
    body = read_body(bodies.written(bodies.BODIES[case.split()[0]](), tmp_path / "body.step"))
    found = fit_surface(design_of(parts, names, {**stated, "tubes": "equal"}), body)
    check_fit(found)
    lines = found.design.lines
    inner = {tube.tube.length for tube in found.layout.tubes if 0 < tube.segment < lines[tube.line].points}
    assert len(inner) == 1
    steps = []
    for one, other in itertools.pairwise(found.layout.points):
        if one.line == other.line:
            frames = [found.layout.frame(point) for point in (one, other)]
            places = [frame.at(0, 0, found.design.resonator.port_axis_height) for frame in frames]
            steps.append(arc_length(places[0], np.array(frames[0].axes[2]), places[1], np.array(frames[1].axes[2])))
    assert np.std(steps) < 0.01 * np.mean(steps)
    scatter = f"scatter by {100 * np.std(steps) / np.mean(steps):.1f} %"
    assert any(scatter in finding for finding in found.findings)


@pytest.fixture(scope="module")
def example():
    return geometry.load_design(EXAMPLE / "fingertip.toml")


def test_the_example_has_no_overlap_and_few_kinds_of_shells(example):
    layout = lay_out(example)
    assert overlaps(example, layout) == ()
    assert example.point_count == 24
    assert len({point.turned[0] for point in layout.points}) <= 12
    assert all(point.position != (0.0, 0.0) for point in layout.points)
    assert max(array_size(example)) < 30
    assert all(least_angle(point.port_angles) >= 45 - 1e-9 for point in layout.points)


def test_shells_of_the_example_stand_on_the_capsule(example):
    base = example.surface.base + example.resonator.floor_thickness
    for part in example.layout.frozen.points:
        x, y, z = part.at
        radius = np.hypot(x, y) if z < 18 else np.linalg.norm([x, y, z - 18])
        assert radius == pytest.approx(9 + base, abs=0.05)
        outwards = np.array([x, y, max(z - 18, 0.0)]) / radius
        assert outwards @ part.normal > 0.995


def test_the_gap_of_the_example_is_that_between_its_undersides_and_the_capsule(example):
    """Largest difference of the distances of one underside's places from the capsule, in closed form."""
    layout, resonator, microphone = lay_out(example), example.resonator, example.microphone
    below = microphone.wall_thickness + microphone.chamber_height / 2 - resonator.port_axis_height
    discs = [(point, resonator.outer_diameter / 2, resonator.floor_thickness) for point in layout.points]
    trunk = microphone.chamber_diameter / 2 + microphone.wall_thickness
    discs += [(each, trunk, max(below, resonator.floor_thickness)) for each in layout.microphones]
    gaps = []
    for part, radius, under in discs:
        angles = np.linspace(0, 2 * np.pi, 73)
        rim = [layout.frame(part).at(radius * np.cos(a), radius * np.sin(a), -under) for a in angles]
        x, y, z = np.array([layout.frame(part).at(0.0, 0.0, -under), *rim]).T
        gaps.append(np.ptp(np.hypot(np.hypot(x, y), np.maximum(z - 18, 0.0))))
    (words,) = [each for each in example.layout.frozen.findings if each.startswith("gaps")]
    assert float(words.split()[4]) == pytest.approx(max(gaps), abs=0.015)


def test_the_cells_of_the_example_are_those_of_places_thrown_at_the_capsule(example):
    """Against great circles and lines of the half ball and cylinder, whose region is known in closed form."""
    top = 9 + 0.4 + 0.6 + 1.3 + 0.2
    random = np.random.default_rng(5)
    ball = random.normal(size=(200_000, 3))
    ball /= np.linalg.norm(ball, axis=1, keepdims=True)
    ball = ball[(ball[:, 2] > 0) & (ball @ (0.8, 0, 0.6) > np.cos(np.radians(78)))]
    along, turn = random.uniform(5, 18, 200_000), random.uniform(-np.pi, np.pi, 200_000)
    side = np.column_stack([np.cos(turn), np.sin(turn), 0 * turn])
    facing = side @ (0.8, 0, 0.6) > np.cos(np.radians(78))
    # As many places of the side as of the ball by area: 2 pi r h of 200 000 against 4 pi r^2.
    facing &= random.uniform(size=200_000) < 13 / (2 * top)
    places = np.vstack(
        [ball * top + (0, 0, 18), side[facing] * top + np.column_stack([0 * turn, 0 * turn, along])[facing]]
    )
    frames = [lay_out(example).frame(point) for point in lay_out(example).points]
    middles = np.array([frame.at(0, 0, 1.5) for frame in frames])
    away = np.linalg.norm(places[:, None] - middles[None], axis=2).min(axis=1) - 0.8
    cells = example.layout.frozen.cells
    area = sum(cell.area for cell in cells)
    assert area == pytest.approx(4 * np.pi * top**2 * len(places) / 200_000, rel=0.03)
    for radius in (0.5, 1.5, 2.5):
        reached = sum(cell.area * np.interp(radius, cell.distances, np.linspace(0, 1, 21)) for cell in cells) / area
        assert reached == pytest.approx((away <= radius).mean(), abs=0.03)


def test_a_later_default_makes_no_old_places_new(example, monkeypatch):
    """Places that were fitted before there was a field stay those of its first value, whatever its default becomes."""
    stated = example.surface
    before, equal = inputs_of(stated), inputs_of(stated.model_copy(update={"tubes": "equal"}))
    assert before == example.layout.frozen.inputs != equal
    monkeypatch.setattr(SurfaceFit.model_fields["tubes"], "default", "equal")
    assert (inputs_of(stated), inputs_of(stated.model_copy(update={"tubes": "equal"}))) == (before, equal)


def test_a_fitted_design_is_written_as_the_files_that_the_fit_took_and_wrote(example, tmp_path):
    path = save_fitted(example, tmp_path)
    assert geometry.load_design(path) == example
    assert (tmp_path / "robot-fingertip.places.json").read_bytes() == (EXAMPLE / "fingertip.places.json").read_bytes()
    assert open_design(path) == example
    (tmp_path / "robot-fingertip.places.json").unlink()
    unfitted = open_design(path)
    assert (unfitted.layout.kind, unfitted.surface, unfitted.point_count) == ("serpentine", example.surface, 1)
    shutil.copy(EXAMPLE / "fingertip.step", tmp_path)
    task = read_fit(path)
    assert (task.design, task.places.name) == (unfitted, "robot-fingertip.places.json")


@pytest.mark.slow
def test_the_example_is_as_the_command_writes_it(tmp_path):
    for name in ("fingertip.toml", "fingertip.step"):
        shutil.copy(EXAMPLE / name, tmp_path / name)
    found, places = fit_design(tmp_path / "fingertip.toml")
    check_fit(found)
    first = places.read_bytes()
    fit_design(tmp_path / "fingertip.toml")
    assert places.read_bytes() == first
    again = geometry.load_design(tmp_path / "fingertip.toml")
    assert again.lines == found.design.lines

    text = (tmp_path / "fingertip.toml").read_text(encoding="utf-8")
    (tmp_path / "fingertip.toml").write_text(text.replace("pitch = 6.0", "pitch = 5.5"), encoding="utf-8")
    with refused(Kind.CONFLICT, "surface") as error:
        geometry.load_design(tmp_path / "fingertip.toml")
    assert "fit again" in error.value.remedy
    (tmp_path / "fingertip.toml").write_text(text, encoding="utf-8")
    with open(tmp_path / "fingertip.step", "a", encoding="utf-8") as file:
        file.write(" ")
    with refused(Kind.CONFLICT, "surface.body"):
        geometry.load_design(tmp_path / "fingertip.toml")


@pytest.mark.slow
@pytest.mark.parametrize("case", ["capsule", "capsule in pockets", "handle", "palm", "panel"])
def test_an_array_on_a_body_keeps_every_rule(case, tmp_path):
    check_fit(fitted(case, tmp_path))


@pytest.mark.slow
def test_parts_on_a_body_go_together(example):
    from geometry.assembly.fit import misfits
    from geometry.assembly.model import array_model

    assert misfits(array_model(example)) == ()


@pytest.mark.slow
def test_membranes_of_an_array_in_pockets_are_flush_with_the_body(tmp_path):
    found = fitted("capsule in pockets", tmp_path)
    membrane = found.design.resonator.cavity_height + found.design.membrane.thickness
    for part in found.design.layout.frozen.points:
        x, y, z = np.array(part.at) + membrane * np.array(part.normal)
        radius = np.hypot(x, y) if z < 18 else np.linalg.norm([x, y, z - 18])
        assert radius == pytest.approx(9, abs=0.06)


# -- order, ports and plan -----------------------------------------------------------------------------
@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("counts", [[8], [4, 4]])
def test_the_order_of_few_points_is_close_to_the_best_of_all(seed, counts):
    places = np.random.default_rng(seed).uniform(0, 4, (8, 2))
    apart = np.linalg.norm(places[:, None] - places[None], axis=2)
    ends = np.random.default_rng(seed + 9).uniform(0, 4, (len(counts) + 1, 8))
    order = Order(apart, ends, counts, 1.0)

    def cost(tour):
        own = sum(order.cost[pair] for pair in steps_of(tour, counts))
        stops = np.cumsum([0, *counts])
        for k in range(len(counts)):
            own += order.ends[k, tour[stops[k]]] + order.ends[k + 1, tour[stops[k + 1] - 1]]
        return own

    best = min(map(cost, itertools.permutations(range(8))))
    assert cost(order.found(seed)) <= 1.03 * best


def test_crossing_steps_are_found():
    places = np.array([[0.0, 0, 0], [1, 1, 0], [0, 1, 0], [1, 0, 0], [2, 0, 0]])
    normals = np.tile([0.0, 0.0, 1.0], (5, 1))
    assert crossings([(0, 1), (2, 3)], places, normals) == [(0, 1)]
    assert crossings([(0, 2), (1, 3), (3, 4)], places, normals) == []


def test_ports_are_rounded_by_turning_both_tubes_alike():
    angles = np.radians([10.0, 52.0, 100.0, 187.0, 340.0])
    forward, normals = np.tile([1.0, 0.0, 0.0], (5, 1)), np.tile([0.0, 0.0, 1.0], (5, 1))
    backward = np.column_stack([np.cos(angles), np.sin(angles), np.zeros(5)])
    x, ports, turned = rounded_ports(forward, backward, normals, 15.0)
    assert ports.tolist() == [45, 45, 105, 180, 315]
    halves = (ports - np.degrees(angles)) / 2
    np.testing.assert_allclose(np.degrees(np.arctan2(x[:, 1], x[:, 0])), -halves, atol=1e-9)
    assert turned == pytest.approx(np.abs(halves).max())


def test_a_plan_of_places_in_a_plane_is_that_plane():
    places = np.column_stack([np.random.default_rng(1).uniform(0, 40, (30, 2)), np.zeros(30)])
    found = unrolled(places, np.tile([0.0, 0.0, 1.0], (30, 1)), 8.0)
    apart, own = (np.linalg.norm(p[:, None] - p[None], axis=2) for p in (places[:, :2], found))
    near = apart < 10
    np.testing.assert_allclose(own[near], apart[near], rtol=0.03, atol=0.05)
    # Seen from outside: three places turn the same way round.
    a, b = places[1, :2] - places[0, :2], places[2, :2] - places[0, :2]
    p, q = found[1] - found[0], found[2] - found[0]
    assert np.sign(a[0] * b[1] - a[1] * b[0]) == np.sign(p[0] * q[1] - p[1] * q[0])


def test_distances_on_a_ball_are_arcs():
    angles = np.radians([0.0, 20.0, 55.0])
    normals = np.column_stack([np.sin(angles), np.zeros(3), np.cos(angles)])
    assert nearest_spacing(12 * normals, normals) == pytest.approx(12 * np.radians([20.0, 20.0, 35.0]))


# -- what cannot be laid -------------------------------------------------------------------------------
def laid(folder, body=bodies.capsule, parts=FINE, names="AB", points=1, **stated):
    path = bodies.written(body(), folder / "body.step")
    fit_surface(design_of(parts, names, {"pitch": 4.0, **stated}, points), read_body(path))


def dumbbell():
    """Two plates joined by a strip."""
    import cadquery as cq

    plates = cq.Workplane().box(30, 30, 4).union(cq.Workplane().box(30, 30, 4).translate((50, 0, 0)))
    return plates.union(cq.Workplane().box(40, 6, 4).translate((25, 0, 0)))


def plate():
    import cadquery as cq

    return cq.Workplane().box(40, 7, 4)


TOP = {"faces": (), "normal": {"towards": (0, 0, 1), "within": 20}}
UNSUITABLE = {
    "an empty region": {"region": {"above": (half((0, 0, 90), (0, 0, 1)),)}},
    "a region without direction": {"region": {"normal": {"towards": (0, 0, 0), "within": 20}}},
    "a strip narrower than two pitches": {"body": plate, "region": TOP},
    "plates that hang together by a strip": {"body": dumbbell, "region": TOP},
    "shells too wide for the body": {"parts": geometry.prototype("array-2x6"), "pitch": 15.0},
    "a pitch at which shells touch": {"pitch": 2.0},
    "more points than there is room for": {"pitch": None, "points": 200, "region": PAD},
    "a microphone that no line has": {"microphones": wishes(C=(0, 0, 0)), "region": PAD},
    "no face for a microphone": {"forbidden": (1, 2, 3), "region": PAD},
}


@pytest.mark.slow
def test_messages(tmp_path):
    calls = {name: partial(laid, tmp_path, **case) for name, case in UNSUITABLE.items()}
    check_messages(HERE / "messages.txt", calls, hidden={f"{tmp_path}/": ""})


FILES = {
    "no table": lambda text: text.split("[surface]")[0] + "[printing]" + text.split("[printing]")[1],
    "no file of places": lambda text: text.replace('places = "fingertip.places.json"', "columns = 4"),
    "points beside a pitch": lambda text: text.replace('between = ["A", "B"]', 'between = ["A", "B"]\npoints = 9'),
    "stated lengths": lambda text: text.replace('between = ["A", "B"]', 'between = ["A", "B"]\nlengths = [1.0]'),
    "no body": lambda text: text.replace("fingertip.step", "missing.step"),
}


def test_messages_of_files(tmp_path):
    text = (EXAMPLE / "fingertip.toml").read_text(encoding="utf-8")

    def call(change):
        (tmp_path / "a.toml").write_text(change(text), encoding="utf-8")
        fit_design(tmp_path / "a.toml")

    calls = {name: partial(call, change) for name, change in FILES.items()}
    check_messages(HERE / "messages_of_files.txt", calls, hidden={f"{tmp_path}/": ""})
