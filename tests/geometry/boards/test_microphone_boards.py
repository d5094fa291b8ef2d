"""Boards of microphones: pads where KiCad's own footprints have them, nets joined, distances kept, files read back."""

from __future__ import annotations

import math
import zipfile
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import cadquery as cq
import numpy as np
import pytest
from refusals import refused

import geometry
from geometry import Kind
from geometry.boards import (
    BoardPlan,
    BoardRules,
    board_drawing,
    board_solid,
    closest,
    plan_board,
    shown_board,
    solid_of_plan,
    write_board,
)
from geometry.boards.board_pieces import Track
from geometry.design.array_design import ArrayDesign
from geometry.stock import StockMicrophone, catalogue
from geometry.stock.stock_files import VARIABLE

#: Pads of KiCad's footprints and their sound hole, by microphone: x, y with y downwards, mm.
KICAD = {
    "SPH1878LR5H-C": {
        "1": (-0.8375, -1.304), "2": (-0.8375, -0.482), "4": (0.8375, -0.482), "5": (0.8375, -1.304), "": (0, 0.77),
    },
    "ICS-43434": {
        "1": (-0.9, -1.364), "2": (-0.9, -0.542), "4": (0.9, -0.542), "5": (0.9, -1.364), "6": (0, -1.364),
        "": (0, 0.71),
    },
    "IM69D130V01": {
        "1": (-1.5, -0.85), "2": (-0.8, -0.85), "3": (-1.5, 0.85), "4": (-0.8, 0.85), "": (0.68, 0),
    },
}  # fmt: skip
DRAWN = (*KICAD, "SPH0645LM4H-B")


def design_with(model: str) -> ArrayDesign:
    microphone = catalogue().microphone(model)
    assert isinstance(microphone, StockMicrophone)
    return geometry.prototype("array-2x6").with_values(dict(microphone.values))


@pytest.fixture(scope="module", params=DRAWN)
def plan(request: pytest.FixtureRequest) -> BoardPlan:
    return plan_board(design_with(request.param))


# -- the plan -----------------------------------------------------------------------------------------
def test_every_microphone_with_a_land_pattern_is_drawn_and_listed_here() -> None:
    assert {each.part_number for each in catalogue().of(StockMicrophone) if each.land_pattern} == set(DRAWN)


def test_the_board_fills_its_seat_and_its_neck_goes_through_the_slot(plan: BoardPlan) -> None:
    microphone = design_with(plan.microphone).microphone
    length, width = microphone.board_size
    corners = np.array(plan.outline)
    seat = corners[corners[:, 0] > -length / 2 - 1e-9]
    assert np.ptp(seat, axis=0) == pytest.approx((length, width))
    outside = -(length / 2 + microphone.board_gap + microphone.wall_thickness)
    in_the_wall = corners[(corners[:, 0] <= -length / 2) & (corners[:, 0] > outside - 0.35)]
    neck = np.abs(in_the_wall[np.abs(in_the_wall[:, 1]) < width / 2 - 1e-9][:, 1]).max()
    assert 2 * neck == pytest.approx(0.6 * (width + 2 * microphone.board_gap) - 2 * microphone.board_gap)
    assert plan.head[1][0] < outside  # the head begins outside the housing
    assert plan.thickness == microphone.sound_hole_length


def test_the_sound_hole_is_that_of_the_design_and_wholly_in_the_chamber(plan: BoardPlan) -> None:
    microphone = design_with(plan.microphone).microphone
    hole = plan.sound_hole
    assert hole.diameter == microphone.sound_hole_diameter
    inside = microphone.chamber_diameter / 2 - math.hypot(*hole.centre) - hole.diameter / 2
    assert plan.in_chamber == pytest.approx(inside)
    assert inside >= BoardRules().chamber  # the board can move as far in its seat
    if plan.microphone == "SPH1878LR5H-C":
        assert inside == pytest.approx(0.3)
    assert plan.ring.centre == hole.centre
    (left, low), (right, high) = plan.package
    length, _ = microphone.board_size
    assert -length / 2 < left < right < length / 2
    assert (high - low, right - left) == pytest.approx((microphone.package_width, microphone.package_length))


def test_a_track_too_near_breaks_a_rule_and_the_place_is_named(plan: BoardPlan) -> None:
    assert all(spacing.kept for spacing in closest(plan))
    pad = next(pad for pad in plan.pads if pad.part == "MK1")
    near = Track("OTHER", "top", ((pad.centre[0], pad.centre[1] + pad.size[1] / 2 + 0.2), (3, 5)), 0.15)
    found = {each.rule: each for each in closest(replace(plan, tracks=(*plan.tracks, near)))}
    assert not found["spacing"].kept
    assert found["spacing"].value <= 0.125 + 1e-9  # 0.2 mm less half of the track
    assert "track OTHER" in found["spacing"].where
    assert not found["edge"].kept  # it leaves the board
    fine = {each.rule: each.kept for each in closest(plan, BoardRules(drill=0.35))}
    assert not fine["drill"]


def test_a_rule_that_is_not_positive_is_refused() -> None:
    with refused(kind=Kind.OUT_OF_RANGE, field="rules.track", value=0.0):
        BoardRules(track=0.0)


def test_a_board_with_room_keeps_glue_away_from_the_sound_hole() -> None:
    for name in ("line-2", "fingertip-4x6", "glove", "large-area-64"):
        assert plan_board(geometry.prototype(name)).in_chamber >= 0.3 - 1e-9
    # The tracks of a digital microphone need room beside the package; a longer board has it.
    short = plan_board(design_with("ICS-43434"))
    longer = plan_board(design_with("ICS-43434").with_values({"microphone.board_length": 5.0}))
    assert BoardRules().chamber <= short.in_chamber < 0.3 <= longer.in_chamber + 1e-9


def test_pin_1_is_marked_beside_the_package_and_nearest_to_its_pad(plan: BoardPlan) -> None:
    mark = plan.pin_mark
    assert mark is not None
    pads = {pad.number: pad.centre for pad in plan.pads if pad.part == "MK1"}
    assert min(pads, key=lambda number: math.dist(pads[number], mark.centre)) == "1"
    (_, low), (_, high) = plan.package
    _, width = design_with(plan.microphone).microphone.board_size
    apart = max(low - mark.centre[1], mark.centre[1] - high) - mark.diameter / 2
    assert apart >= 0.1 - 1e-9  # in sight beside the package, which is soldered on
    assert width / 2 - abs(mark.centre[1]) - mark.diameter / 2 >= 0.1 - 1e-9
    assert not any(
        abs(mark.centre[0] - x) < pad.size[0] / 2 and abs(mark.centre[1] - y) < pad.size[1] / 2 + mark.diameter / 2
        for pad in plan.pads
        for x, y in [pad.centre]
    )


def test_a_board_as_narrow_as_its_package_has_no_mark() -> None:
    narrow = design_with("SPH1878LR5H-C").with_values({"microphone.board_width": 3.1})
    assert plan_board(narrow).pin_mark is None


# -- the solid ----------------------------------------------------------------------------------------
def test_the_solid_is_the_board_that_is_ordered(plan: BoardPlan) -> None:
    solid = solid_of_plan(plan).val()
    box = solid.BoundingBox()
    assert (box.xlen, box.ylen, box.zlen) == pytest.approx((*plan.size, plan.thickness))
    x, y = np.array(plan.outline).T
    area = abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))) / 2
    bores = [plan.sound_hole.diameter, plan.tie_hole.diameter, *(pad.drill for pad in plan.pads)]
    assert solid.Volume() == pytest.approx((area - math.pi / 4 * np.sum(np.square(bores))) * plan.thickness)
    middle = cq.Vector(*plan.sound_hole.centre, plan.thickness / 2)
    assert not solid.isInside(middle)


def test_the_solids_of_an_array_show_the_whole_board_and_a_body_only_its_seat() -> None:
    design = geometry.prototype("array-2x6")
    plan = plan_board(design)
    assert shown_board(design) == plan
    assert board_solid(design).val().BoundingBox().xlen == pytest.approx(plan.size[0])
    unknown = design.with_values({"microphone.model": "my own"})
    assert shown_board(unknown) is None
    assert board_solid(unknown).val().BoundingBox().xlen == pytest.approx(design.microphone.board_size[0])
    frozen = geometry.load_design(Path(__file__).parents[3] / "docs" / "examples" / "robot" / "palm.toml")
    assert frozen.layout.frozen is not None
    assert shown_board(frozen) is None  # its neck is bent there
    assert board_solid(frozen).val().BoundingBox().xlen == pytest.approx(frozen.microphone.board_size[0])


# -- boards that are not drawn ------------------------------------------------------------------------
def test_a_microphone_without_land_pattern_has_no_board_and_the_others_are_named() -> None:
    with refused(kind=Kind.MISSING, field="microphone.model", value="IM73A135V01") as refusal:
        plan_board(design_with("IM73A135V01"))
    assert "IM69D130V01" in str(refusal.value)


def test_a_microphone_of_nobody_has_no_board() -> None:
    with refused(kind=Kind.MISSING, field="microphone.model", value="my own"):
        plan_board(geometry.prototype("array-2x6").with_values({"microphone.model": "my own"}))


def test_a_microphone_with_its_hole_at_the_top_has_no_board(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    row = {"part_number": "top", "output": "analog", "sensitivity": -38, "signal_to_noise": 60, "port": "top"}
    row |= {"length": 3.5, "width": 2.65, "height": 1.0, "price": 1, "price_date": "2025", "source": "assumed"}
    lines = ["[[microphone]]", *(f"{name} = {value!r}" for name, value in row.items())]
    (tmp_path / "own.toml").write_text("\n".join(lines), encoding="utf-8")
    monkeypatch.setenv(VARIABLE, str(tmp_path / "own.toml"))
    with refused(kind=Kind.UNSUITABLE, field="microphone.model", value="top"):
        plan_board(geometry.prototype("array-2x6").with_values({"microphone.model": "top"}))


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"microphone.board_length": 3.5, "microphone.package_length": 3.4}, "smaller than the package"),
        ({"microphone.chamber_diameter": 1.2, "microphone.board_length": 3.7}, "outside the chamber"),
        ({"microphone.chamber_diameter": 1.0, "microphone.sound_hole_diameter": 0.9}, "too wide for the chamber"),
        ({"microphone.sound_hole_diameter": 0.7}, "ring 3 and sound hole"),
    ],
)
def test_a_board_without_room_is_refused_with_the_place(values: dict[str, Any], words: str) -> None:
    with pytest.raises(geometry.Refusal, match=words) as refusal:
        plan_board(geometry.prototype("array-2x6").with_values(values))
    assert refusal.value.kind is Kind.UNSUITABLE


# -- the files, read by programs of others --------------------------------------------------------------
def _triple(places: dict[str, tuple[float, float]], names: list[str]) -> float:
    """Twice the signed area of three pads, mm^2: the same in every rotation, of the other sign in a mirror."""
    (ax, ay), (bx, by), (cx, cy) = (places[name] for name in names)
    return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)


@pytest.mark.parametrize("model", KICAD)
def test_the_footprint_is_that_of_kicad_turned_but_not_mirrored(model: str, tmp_path: Path) -> None:
    kicad = pytest.importorskip("gerbonara.cad.kicad.pcb", reason="gerbonara is in the extra dev")
    board = kicad.Board.open(write_board(plan_board(design_with(model)), tmp_path)[0])
    microphone = next(each for each in board.footprints if "MK1" in each.name)
    # The ring's pad lies on its copper, so the hole stands for it.
    placed = {pad.number: (pad.at.x, pad.at.y) for pad in microphone.pads if str(pad.shape) != "custom"}
    own = KICAD[model]
    assert placed.keys() == own.keys()
    names = list(own)
    for k, one in enumerate(names):
        for other in names[k + 1 :]:
            assert math.dist(placed[one], placed[other]) == pytest.approx(math.dist(own[one], own[other]), abs=1e-5)
    corner = [names[0], names[-2], ""]
    assert _triple(placed, corner) == pytest.approx(_triple(own, corner), abs=1e-5)
    assert abs(_triple(own, corner)) > 0.5


def test_kicad_reads_back_pads_nets_holes_and_outline(plan: BoardPlan, tmp_path: Path) -> None:
    kicad = pytest.importorskip("gerbonara.cad.kicad.pcb", reason="gerbonara is in the extra dev")
    board = kicad.Board.open(write_board(plan, tmp_path)[0])
    assert list(board.nets.values()) == ["", *plan.nets]
    found = {
        (each.name.split(":")[1], pad.number): (each.at.x + pad.at.x - 100, 100 - each.at.y - pad.at.y, pad)
        for each in board.footprints
        for pad in each.pads
    }
    for pad in plan.pads:
        x, y, read = found[pad.part, pad.number]
        assert (x, y) == pytest.approx(pad.centre, abs=1e-5)
        assert (read.size.x, read.size.y) == pytest.approx(pad.size)
        assert read.net.name == pad.net
    x, y, read = found["MK1", ""]
    assert (x, y, read.drill.diameter) == pytest.approx((*plan.sound_hole.centre, plan.sound_hole.diameter), abs=1e-5)
    assert found["MK1", plan.ring.number][2].net.name == plan.ring.net
    mark = plan.pin_mark
    assert mark is not None
    microphone = next(each for each in board.footprints if "MK1" in each.name)
    (dot,) = (circle for circle in microphone.circles if circle.layer == "F.SilkS")
    x, y = microphone.at.x + dot.center.x - 100, 100 - microphone.at.y - dot.center.y
    assert (x, y) == pytest.approx(mark.centre, abs=1e-5)
    reach = math.dist((dot.center.x, dot.center.y), (dot.end.x, dot.end.y)) + dot.stroke.width / 2
    assert 2 * reach == pytest.approx(mark.diameter, abs=1e-5)
    edges = [line for line in board.lines if line.layer == "Edge.Cuts"]
    drawn = {(round(line.start.x - 100, 5), round(100 - line.start.y, 5)) for line in edges}
    assert drawn == {(round(a, 5), round(b, 5)) for a, b in plan.outline}


@pytest.fixture(scope="module")
def layers(plan: BoardPlan, tmp_path_factory: pytest.TempPathFactory) -> Any:
    gerbonara = pytest.importorskip("gerbonara", reason="gerbonara is in the extra dev")
    folder = tmp_path_factory.mktemp("board")
    write_board(plan, folder)
    return gerbonara.LayerStack.open(folder / "gerber")


def _pieces(layer: Any) -> Iterator[Any]:
    """Copper of a layer as shapes; a hole in an aperture is cut out."""
    shapely = pytest.importorskip("shapely", reason="shapely is in the extra dev")
    from gerbonara import graphic_primitives as primitives
    from gerbonara.utils import MM

    for each in layer.objects:
        shape = shapely.Polygon()
        for part in each.to_primitives(unit=MM):
            if isinstance(part, primitives.Circle):
                one = shapely.Point(part.x, part.y).buffer(part.r, 64)
            elif isinstance(part, primitives.Line):
                one = shapely.LineString([(part.x1, part.y1), (part.x2, part.y2)]).buffer(part.width / 2, 64)
            else:
                assert isinstance(part, primitives.Rectangle)
                assert part.rotation == 0
                w, h = part.w / 2, part.h / 2
                one = shapely.box(part.x - w, part.y - h, part.x + w, part.y + h)
            shape = shape.union(one) if part.polarity_dark else shape.difference(one)
        yield shape


def test_the_copper_of_the_gerber_files_joins_every_net_and_keeps_its_distances(plan: BoardPlan, layers: Any) -> None:
    """The copper is read from the files by gerbonara and measured by shapely, which the plan uses neither."""
    shapely = pytest.importorskip("shapely", reason="shapely is in the extra dev")
    rules = BoardRules()
    board = shapely.Polygon(plan.outline)
    holes = [shapely.Point(bore.centre).buffer(bore.diameter / 2, 64) for bore in (plan.sound_hole, plan.tie_hole)]
    islands = {}
    for side in ("top", "bottom"):
        copper = shapely.union_all(list(_pieces(layers.graphic_layers[side, "copper"])))
        islands[side] = list(copper.geoms) if copper.geom_type == "MultiPolygon" else [copper]
        apart = [one.distance(other) for k, one in enumerate(islands[side]) for other in islands[side][k + 1 :]]
        assert min(apart) >= rules.spacing - 1e-3
        assert board.boundary.distance(copper) >= rules.edge - 1e-3
        assert board.contains(copper)
        assert min(hole.distance(copper) for hole in holes) >= rules.hole - 1e-3
    least = {each.rule: each.value for each in closest(plan)}
    top = islands["top"]
    apart = [one.distance(other) for k, one in enumerate(top) for other in top[k + 1 :]]
    assert min(apart) == pytest.approx(least["spacing"], abs=2e-3)
    # Islands of both sides that a plated hole joins are one net.
    joined = [(side, k) for side in islands for k in range(len(islands[side]))]
    parent = {each: each for each in joined}

    def root(each: tuple[str, int]) -> tuple[str, int]:
        return each if parent[each] == each else root(parent[each])

    def island(side: str, place: tuple[float, float]) -> tuple[str, int]:
        (found,) = (k for k, shape in enumerate(islands[side]) if shape.contains(shapely.Point(place)))
        return side, found

    for drill in layers.drill_pth.objects:
        parent[root(island("top", (drill.x, drill.y)))] = root(island("bottom", (drill.x, drill.y)))
        assert least["annular"] >= rules.annular
    nets: dict[str, set[tuple[str, int]]] = {}
    for pad in plan.pads:
        nets.setdefault(pad.net, set()).add(root(island("top", pad.centre)))
    x, y = plan.ring.centre
    nets[plan.ring.net].add(root(island("top", (x + (plan.ring.inner + plan.ring.outer) / 4, y))))
    assert all(len(roots) == 1 for roots in nets.values()), nets
    assert len({next(iter(roots)) for roots in nets.values()}) == len(plan.nets)


def test_holes_mask_and_outline_of_the_gerber_files_are_those_of_the_plan(plan: BoardPlan, layers: Any) -> None:
    shapely = pytest.importorskip("shapely", reason="shapely is in the extra dev")
    plain = sorted((o.x, o.y, o.tool.diameter) for o in layers.drill_npth.objects)
    bores = sorted((*bore.centre, bore.diameter) for bore in (plan.sound_hole, plan.tie_hole))
    assert np.allclose(plain, bores, atol=1e-3)
    assert len(layers.drill_pth.objects) == len(plan.vias) + len(plan.wires)
    outline = shapely.union_all(list(_pieces(layers.outline)))
    assert shapely.Polygon(plan.outline).boundary.difference(outline).length < 1e-6
    mask = shapely.union_all(list(_pieces(layers.graphic_layers["top", "mask"])))
    for pad in plan.pads:
        assert mask.contains(shapely.Point(pad.centre).buffer(min(pad.size) / 2))
    assert not any(mask.intersects(shapely.Point(via.centre)) for via in plan.vias)  # vias are covered, so no air leaks
    silk = shapely.union_all(list(_pieces(layers.graphic_layers["top", "silk"])))
    assert plan.pin_mark is not None
    assert silk.contains(shapely.Point(plan.pin_mark.centre).buffer(0.49 * plan.pin_mark.diameter))
    assert not silk.intersects(mask)  # ink on a pad keeps solder away
    assert not plan.vias or math.hypot(*plan.vias[0].centre) > 0.95 + 0.3  # and lie outside the chamber


def test_two_writings_are_equal_and_the_archive_holds_the_layers(plan: BoardPlan, tmp_path: Path) -> None:
    first, second = (write_board(plan, tmp_path / name) for name in ("first", "second"))
    assert [path.read_bytes() for path in first] == [path.read_bytes() for path in second]
    archive = next(path for path in first if path.suffix == ".zip")
    with zipfile.ZipFile(archive) as packed:
        assert sorted(packed.namelist()) == sorted(path.name for path in (tmp_path / "first" / "gerber").iterdir())
    svg = board_drawing(plan, "a < b")
    assert svg.count("<text") >= len(plan.pads) + len(plan.words) - 2
    assert 'aria-label="a &lt; b"' in svg
    assert "pin 1 of MK1" in svg
