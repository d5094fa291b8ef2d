"""What to order, how long it takes, and what to cut: counted again from the design, and read back by other programs."""

from __future__ import annotations

import csv
import math
import re
import zlib
from pathlib import Path
from typing import Any

import ezdxf
import pytest
from refusals import refused

import geometry
from geometry.assembly.bill import bill_of_materials
from geometry.assembly.model import ArrayModel, array_model
from geometry.ground.refusal import Kind
from geometry.layout import cutting_list, lay_out
from geometry.schema.print_processes import process_of
from geometry.stock import Sheath
from studies.kit import Spares
from studies.kit.build_facts import casts_of
from studies.kit.cutting_template import (
    LONGEST,
    PAGES,
    SCALE_BAR,
    SLEEVE_SHORTENS,
    SPARE_PIECES,
    template_strips,
    write_cutting,
)
from studies.kit.ordering import UNGLUED, OrderList, order_list
from studies.kit.step_tools import HAVE_READY, tools_of
from studies.kit.tube_order import sheath_orders, spring_orders, write_tube_order
from studies.kit.work_hours import work_of


@pytest.fixture(scope="module")
def model() -> ArrayModel:
    return array_model("array-2x6")


@pytest.fixture(scope="module")
def order(model: ArrayModel) -> OrderList:
    process = process_of(model.design.printing)
    bill = bill_of_materials(model.design, model.parts, model.layout)
    return order_list(model.design, bill, work_of(model, 2, process, 6.0, 5.0), process, casts_of(model, bill))


def test_the_order_has_the_bill_with_spares_and_what_the_bill_leaves_out(order: OrderList) -> None:
    by_item = {line.item: line for line in order.lines}
    for item in order.bill.items:
        assert by_item[item.item].needed == pytest.approx(item.quantity) or item.count > 1
    microphones = by_item["SPH1878LR5H-C"]
    assert (microphones.needed, microphones.spare, microphones.ordered) == (2, 1, 3)
    assert by_item["mold-base"].spare == 0  # a mold is made once
    shell = next(item for item in order.bill.items if item.item == "shell-corner-90")
    assert by_item[shell.item].spare == pytest.approx(shell.quantity / 2)  # a tenth of two, rounded up
    # The mold has a cavity for each point and none for spares, so two cups of 5 g are mixed; 1120 kg/m^3.
    assert (by_item["membrane"].needed, by_item["membrane"].spare) == pytest.approx((5 / 1.12, 5 / 1.12))
    assert {line.purpose for line in order.lines} == {"array", "molds", "electronics", "consumable", "tool"}
    counted = [line for line in order.lines if line.part and line.purpose != "electronics"]
    assert order.cost() == pytest.approx(math.fsum(line.ordered * line.part.price for line in counted if line.part))
    loggers = [line for line in order.lines if line.item == "data logger"]
    assert [line.ordered for line in loggers] == [1, 0]  # one of two is ordered
    assert order.cost("electronics") > loggers[0].cost > 0
    assert order.cost_of_packs > order.cost() > order.bill.cost
    rows = list(csv.DictReader(order.to_csv().splitlines()))
    listed = order.cost() + order.cost("electronics")
    assert math.fsum(float(row["cost"]) for row in rows) == pytest.approx(listed, abs=0.01 * len(rows))


def test_the_sums_of_the_costs_are_those_of_their_rows(order: OrderList) -> None:
    rows = [list(row.values()) for row in csv.DictReader(order.costs_csv().splitlines())]
    names = [row[0] for row in rows]
    cost = {name: float(row[-1]) for name, row in zip(names, rows, strict=True)}
    for row in rows:
        if row[2]:
            assert float(row[-1]) == pytest.approx(float(row[2]) * float(row[4]), abs=0.006)
            assert float(row[2]) >= float(row[1])  # whole packs hold what is needed
    first, second = names.index("sum of whole packs"), names.index("sum of electronics")
    packs, electronics = rows[:first], rows[first + 1 : second]
    assert math.fsum(float(row[-1]) for row in packs) == pytest.approx(order.cost_of_packs, abs=0.005 * len(packs))
    summed = math.fsum(float(row[-1]) for row in electronics)
    assert summed == pytest.approx(cost["sum of electronics"], abs=0.005 * len(electronics))
    assert cost["everything"] == pytest.approx(cost["sum of whole packs"] + cost["sum of electronics"], abs=0.011)


def test_each_step_names_only_things_that_are_ordered_or_stated_as_ready(order: OrderList) -> None:
    listed = {line.item for line in order.lines if line.ordered}
    steps = tools_of(order)
    assert list(steps) == list(range(1, 15))
    for step, tools in steps.items():
        for tool in tools.split(", "):
            assert tool in listed or tool in HAVE_READY, f"step {step}: {tool}"
    assert "primer" in steps[10]  # cyanoacrylate does not hold polyethylene
    used = {tool for tools in steps.values() for tool in tools.split(", ")}
    assert set(HAVE_READY) <= used
    bought = {line.item for line in order.lines if line.purpose in ("tool", "consumable") and line.ordered}
    assert bought <= used


def test_a_tubing_that_needs_no_primer_orders_none() -> None:
    design = geometry.prototype("line-2").with_values({"lines.0.points": 2, "tube.bore": "smooth"})
    design = design.with_values({"microphone_tube.bore": "smooth"})
    drawn = array_model(design)
    bill = bill_of_materials(design, drawn.parts, drawn.layout)
    process = process_of(design.printing)
    order = order_list(design, bill, work_of(drawn, 2, process, 6.0, 5.0), process, casts_of(drawn, bill))
    material = next(item.part for item in bill.items if item.item.startswith("sheath"))
    assert isinstance(material, Sheath)
    assert ("primer" in {line.item for line in order.lines}) == (material.material in UNGLUED)


def test_the_order_has_the_length_of_all_pieces_and_their_spares(order: OrderList, model: ArrayModel) -> None:
    strips = template_strips(model.design, model.layout)
    for what in ("spring", "sheath"):
        (line,) = [line for line in order.lines if line.item.startswith(what)]  # one row of one part
        cut = sum(
            (strip.count + SPARE_PIECES) * ((strip.rough or strip.length) + 0.5)
            for strip in strips
            if strip.what == what
        )
        assert line.ordered * 1000 >= cut
        assert line.needed * 1000 == pytest.approx(
            sum(strip.count * ((strip.rough or strip.length) + 0.5) for strip in strips if strip.what == what)
        )
    sheath = next(strip for strip in strips if strip.what == "sheath")
    assert sheath.rough is not None
    assert sheath.rough * (1 - SLEEVE_SHORTENS) >= sheath.length  # enough is left to trim
    assert all(strip.rough is None for strip in strips if strip.what == "spring")
    assert all(len(strip.boxes) == strip.count + SPARE_PIECES for strip in strips)


def test_springs_and_sheaths_are_ordered_by_sizes_that_their_makers_need(
    order: OrderList, model: ArrayModel, tmp_path: Path
) -> None:
    placed = (model.design, model.layout, order)
    (spring,), (sheath,) = spring_orders(*placed), sheath_orders(*placed)
    cuts = cutting_list(model.design, model.layout)
    assert 1000 * spring.length > 1.1 * sum(cut.count * cut.spring_length for cut in cuts)
    items = {line.item: line for line in order.lines}
    assert spring.length == items["spring 0.6 mm, wire 0.08 mm"].ordered
    assert sheath.length == items["sheath 0.9 mm outside over the spring"].ordered
    assert spring.rod >= max(cut.cut_length for cut in cuts) + 10
    write_tube_order((spring,), (sheath,), tmp_path)
    page = (tmp_path / "order-tubes.txt").read_text(encoding="utf-8")
    rows = dict(re.findall(r"^  (\S.{15}\S?) +(.+)$", page.partition("Sheath 1")[0], re.MULTILINE))
    rows = {name.strip(): words for name, words in rows.items()}
    assert rows["wire"].startswith("0.08 mm")
    assert rows["outside diameter"] == "0.6 mm, plus or minus 0.03 mm"
    assert rows["inside diameter"] == f"{model.design.tube.inner_diameter:g} mm"
    assert rows["pitch"].startswith("0.08 mm")
    assert rows["check on arrival"].startswith("125 turns on 10 mm")
    ordered, needed, spare = (float(value) for value in re.findall(r"(\d+) mm", rows["length in all"]))
    assert needed + spare == pytest.approx(ordered, abs=1)
    assert needed == pytest.approx(sum(cut.count * (cut.spring_length + 0.5) for cut in cuts), abs=0.5)
    assert "makers below" not in page  # the page has no name of a maker
    assert "bore 0.9 mm" in page.partition("Sheath 1")[2]
    assert "over a spring of 0.6 mm, 0.9 mm outside" in page
    assert "order-tubes.txt" in items["spring 0.6 mm, wire 0.08 mm"].note


def test_each_sheath_says_how_it_comes_onto_its_spring() -> None:
    """The large area has a tubing, which does not shrink, and a sleeve, which does."""
    design = geometry.prototype("large-area-64")
    layout, parts = lay_out(design), geometry.build_parts(design)
    bill = bill_of_materials(design, parts, layout)
    lines = order_list(design, bill, (), process_of(design.printing), ())
    tubing, sleeve = sheath_orders(design, layout, lines)
    assert tubing.fitting.startswith("PTFE tubing 0.711 x 1.011 mm does not shrink: slide the spring of 0.7 mm")
    assert dict(tubing.rows())["form"] == "tubing of plain wall, which does not shrink"
    assert dict(tubing.rows())["as supplied"] == "bore 0.711 mm, 1.011 mm outside"
    assert "bore 0.9 mm as supplied and 0.4 mm shrunk freely" in sleeve.fitting
    assert "over the spring of 0.8 mm" in sleeve.fitting
    assert "tight and is 1.1 mm outside" in sleeve.fitting


def test_numbered_parts_of_a_maker_are_on_no_page_to_ask_makers(tmp_path: Path) -> None:
    values: dict[str, Any] = {"lines.0.points": 2}
    for tube in ("tube", "microphone_tube"):
        values |= {f"{tube}.bore": "smooth", f"{tube}.inner_diameter": 0.58, f"{tube}.outer_diameter": 0.965}
    model = array_model(geometry.prototype("line-2").with_values(values))
    process = process_of(model.design.printing)
    bill = bill_of_materials(model.design, model.parts, model.layout)
    casts = casts_of(model, bill)
    listed = order_list(model.design, bill, work_of(model, 2, process, 6.0, 5.0), process, casts)
    assert spring_orders(model.design, model.layout, listed) == ()
    (sheath,) = sheath_orders(model.design, model.layout, listed)
    assert sheath.is_numbered
    write_tube_order((), (sheath,), tmp_path)
    assert not list(tmp_path.iterdir())


def test_hours_are_pieces_by_minutes(order: OrderList, model: ArrayModel) -> None:
    rows = list(csv.DictReader(order.work_csv().splitlines()))
    counted = sum(int(row["pieces"]) * float(row["minutes a piece"]) for row in rows) / 60
    assert counted == pytest.approx(order.hours, rel=1e-9)
    pieces = {row["work"]: int(row["pieces"]) for row in rows}
    assert pieces["glue the end of a tube"] == 2 * 13
    assert pieces["test a joint"] == 2 * 13 + 12
    assert pieces["trim and measure a membrane"] == model.design.point_count


def test_spares_are_fractions_of_at_least_nothing() -> None:
    with refused(kind=Kind.OUT_OF_RANGE, field="spares.tube", value=-0.1):
        Spares(tube=-0.1)


@pytest.mark.parametrize("design", ["array-2x6", "fingertip-4x6", "glove"])
def test_the_template_has_every_piece_at_full_scale(design: str, tmp_path: Path) -> None:
    layout = lay_out(geometry.prototype(design))
    strips = write_cutting(geometry.prototype(design), layout, tmp_path)
    cuts = cutting_list(design)
    assert sum(s.count for s in strips if s.what == "spring") == sum(cut.count for cut in cuts)
    assert {s.length for s in strips if s.what == "sheath"} == {cut.cut_length for cut in cuts}
    assert {s.length for s in strips if s.what == "spring"} == {cut.spring_length for cut in cuts}
    drawing = ezdxf.readfile(tmp_path / "cutting-template.dxf")
    assert drawing.units == ezdxf.units.MM
    assert not drawing.audit().errors
    for what in ("spring", "sheath"):
        drawn: list[Any] = list(drawing.modelspace().query(f'LWPOLYLINE[layer=="{what}"]'))
        lengths = {round(max(x for x, *_ in line) - min(x for x, *_ in line), 6) for line in drawn}
        assert lengths == {round(s.length, 6) for s in strips if s.what == what}
        assert all(line.closed for line in drawn)
    (bar,) = drawing.modelspace().query('LINE[layer=="scale"]')
    assert bar.dxf.end.x - bar.dxf.start.x == SCALE_BAR


@pytest.mark.parametrize("page", PAGES)
def test_the_pdf_is_of_the_size_of_the_paper_and_its_bar_is_100_mm(page: str, tmp_path: Path) -> None:
    write_cutting(geometry.prototype("array-2x6"), lay_out(geometry.prototype("array-2x6")), tmp_path)
    content = (tmp_path / f"cutting-template-{page}.pdf").read_bytes()
    box = re.search(rb"/MediaBox \[ ?0 0 ([\d.]+) ([\d.]+) ?\]", content)
    assert box is not None
    points = 72 / 25.4
    for size, stated in zip(PAGES[page], box.groups(), strict=True):
        assert float(stated) == pytest.approx(size * points, abs=0.1)
    streams = re.findall(rb"stream\r?\n(.*?)\r?\nendstream", content, re.DOTALL)
    drawn = b"".join(zlib.decompress(stream) for stream in streams if stream[:1] == b"x")
    moves = re.findall(rb"([\d.]+) ([\d.]+) m\n([\d.]+) ([\d.]+) l\n", drawn)
    lengths = {round(abs(float(x1) - float(x0)) / points, 2) for x0, y0, x1, y1 in moves if y0 == y1}
    assert SCALE_BAR in lengths


def test_a_piece_longer_than_the_paper_has_a_match_mark() -> None:
    design = geometry.prototype("line-2").with_values({"microphone_tube.length": 200.0})
    longest = max(template_strips(design), key=lambda strip: strip.length)
    assert longest.length > LONGEST
    assert longest.boxes == ((0.0, LONGEST),)


def test_two_writings_of_one_template_are_equal(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1700000000")
    design = geometry.prototype("array-2x6")
    for name in ("first", "second"):
        (tmp_path / name).mkdir()
        write_cutting(design, lay_out(design), tmp_path / name)
    for path in (tmp_path / "first").iterdir():
        assert path.read_bytes() == (tmp_path / "second" / path.name).read_bytes(), path.name
