"""The bill of materials adds up to the parts and tubes of the array."""

import csv
import io
import json
import math

import pytest
from built import built
from refusals import refused
from rings import rectangle

import geometry
from geometry import Kind
from geometry.assembly.bill import Waste, bill_of_materials, write_bill
from geometry.layout.cutting import cutting_list
from geometry.stock import catalogue

OWN = """
[[microphone]]
maker = "Knowles"
part_number = "SPH1878LR5H-C"
output = "analog"
sensitivity = -38.0
signal_to_noise = 66.0
port = "bottom"
length = 3.5
width = 2.65
height = 0.98
price = 11.5
price_date = "2026-11"
price_source = "my shop"
source = "data sheet"
"""
PHYSICAL = ["array-2x6", "fingertip-3x4", "fingertip-4x6", "glove", "large-area-64"]


@pytest.fixture(scope="module")
def bill():
    return bill_of_materials(geometry.prototype("array-2x6"), built("array-2x6"))


def test_millilitres_are_those_of_the_solids_times_their_counts(bill):
    design = geometry.prototype("array-2x6")
    radius = design.resonator.cavity_diameter / 2 + design.membrane.rim_width
    # The discs' edges have the draft of their mold.
    assert bill.silicone_ml == pytest.approx(12 * math.pi * radius**2 * design.membrane.thickness / 1000, rel=3e-3)
    parts = built("array-2x6")
    assert bill.silicone_ml == pytest.approx(12 * parts["membrane"].val().Volume() / 1000)
    printed = [name for name in parts if name.startswith(("shell", "microphone-housing"))]
    volume = sum(parts[name].val().Volume() * parts.counts[name] for name in printed)
    assert bill.resin_ml == pytest.approx(volume / 1000)
    molds = sum(parts[name].val().Volume() * parts.counts[name] for name in parts if name.startswith("mold"))
    assert bill.tooling_resin_ml == pytest.approx(molds / 1000)
    silicone = next(item for item in bill.items if item.use == "cast")
    assert silicone.quantity == pytest.approx(bill.silicone_ml * bill.waste.silicone_factor)


def test_tubes_are_those_of_the_cutting_list_with_what_the_cuts_lose(bill):
    cuts = cutting_list(geometry.prototype("array-2x6"))
    springs = [item for item in bill.items if item.item.startswith("spring")]
    assert [(item.count, item.unit) for item in springs] == [(cut.count, "m") for cut in cuts]
    for item, cut in zip(springs, cuts, strict=True):
        assert item.quantity == pytest.approx(cut.count * (cut.cut_length + 0.5) / 1000)
        assert f"cut to {cut.cut_length:g} mm, {cut.cut_length / 0.08:.0f} turns" in item.note
    assert bill.tube_m == pytest.approx(13 * 11.5 / 1000)


def test_every_part_is_on_the_bill_once_with_its_count(bill):
    parts = built("array-2x6")
    assert {item.item: item.count for item in bill.items if item.item in parts} == parts.counts
    assert next(item.count for item in bill.items if item.item == "SPH1878LR5H-C") == 2
    glues = {item.item: item.count for item in bill.items if item.item.startswith("glue")}
    assert glues == {"glue of tube joints": 2 * 13, "glue of membrane joints": 12, "glue of board joints": 2}


def test_a_board_takes_a_glue_joint_or_a_gasket(bill):
    sealed = geometry.prototype("array-2x6").with_values(
        {"microphone.gasket_width": 0.5, "microphone.gasket_depth": 0.2}
    )
    items = {item.item: item for item in bill_of_materials(sealed).items}
    assert "glue of board joints" not in items
    inside = sealed.microphone.chamber_diameter + 1.2
    assert (items["gasket"].count, items["gasket"].cost) == (2, pytest.approx(0.1))
    assert f"{inside:g} x {inside + 1:g} mm" in items["gasket"].note


@pytest.mark.slow
def test_a_bent_spring_is_bought_as_long_as_its_turns_and_each_piece_says_its_lines():
    items = bill_of_materials(geometry.prototype("fingertip-3x4"), built("fingertip-3x4")).items
    spring = next(item for item in items if item.item.startswith("spring") and "between" in item.note)
    sheath = next(item for item in items if item.item.startswith("sheath") and "between" in item.note)
    assert "cut to 3.37 mm, 67 turns, between points of line 1" in spring.note
    assert "cut to 3.6 mm" in sheath.note
    assert sheath.quantity - spring.quantity == pytest.approx(11 * 0.23e-3)
    ring = rectangle(2)
    notes = [item.note for item in bill_of_materials(ring, geometry.build_parts(ring)).items]
    assert any(note.endswith("between points of lines 1, 3") for note in notes)
    assert any(note.endswith("between points of lines 2, 4") for note in notes)


def test_every_line_names_the_part_that_it_is_bought_as_with_its_price_and_source(bill):
    rows = {item.item: item.to_dict() for item in bill.items}
    stock = catalogue()
    microphone = stock.microphone("SPH1878LR5H-C")
    assert rows["SPH1878LR5H-C"]["maker"] == "Knowles"
    assert rows["SPH1878LR5H-C"]["unit_price"] == microphone.price
    assert rows["membrane"]["part_number"] in {part.part_number for part in stock.listed("silicone")}
    for item in bill.items:
        assert item.part in stock.parts
        assert not item.to_order
        assert item.cost == pytest.approx(item.quantity * item.part.price)
        assert rows[item.item]["price_date"] == item.part.price_date
        assert rows[item.item]["source"] == item.part.source
    assert bill.cost == pytest.approx(sum(item.cost for item in bill.items if item.use != "tooling"))
    assert microphone.price_date in str(bill)


def test_what_the_catalogue_lacks_is_made_to_order_and_the_nearest_is_named():
    items = bill_of_materials(geometry.prototype("fingertip-3x4"), built("fingertip-3x4")).items
    made = [item.item for item in items if item.to_order]
    assert made == ["spring 0.28 mm, wire 0.05 mm", "sheath 0.55 mm outside over the spring"]
    spring = next(item for item in items if item.item == made[0])
    assert spring.part.outer_diameter == 0.5
    assert spring.part.name in spring.bought_as
    assert spring.bought_as != spring.part.name


def test_a_smooth_bore_is_a_tubing_without_a_spring():
    design = geometry.prototype("array-2x6")
    wanted = {"inner_diameter": 0.457, "wire_diameter": 0.08, "outer_diameter": 0.757, "bore": "smooth"}
    values = {f"{tube}.{name}": each for tube in ("tube", "microphone_tube") for name, each in wanted.items()}
    items = bill_of_materials(design.with_values(values)).items
    assert not [item for item in items if item.item.startswith("spring")]
    assert {item.part.kind for item in items if item.item.startswith("sheath")} == {"tubing"}
    assert not any(item.to_order for item in items)


def test_prices_are_those_of_the_users_own_parts(bill, tmp_path):
    (tmp_path / "mine.toml").write_text(OWN, encoding="utf-8")
    own = catalogue(tmp_path)
    dearer = bill_of_materials(geometry.prototype("array-2x6"), built("array-2x6"), stock=own)
    assert dearer.cost - bill.cost == pytest.approx(2 * (11.5 - catalogue().microphone("SPH1878LR5H-C").price))
    assert "my shop" in str(dearer)
    assert "my shop" not in str(bill)


def test_losses_are_the_users_own(bill):
    design, parts = geometry.prototype("array-2x6"), built("array-2x6")
    spare = bill_of_materials(design, parts, waste=Waste(resin_factor=2.6))
    printed = sum(item.cost for item in bill.items if item.use == "printed")
    assert spare.cost - bill.cost == pytest.approx(printed)
    with refused(Kind.OUT_OF_RANGE, "waste.cutting_loss", -1.0):
        Waste(cutting_loss=-1.0)
    with refused(Kind.OUT_OF_RANGE, "waste.resin_factor", 0.5):
        Waste(resin_factor=0.5)


@pytest.mark.parametrize("name", PHYSICAL)
@pytest.mark.slow
def test_a_prototype_costs_what_the_paper_says(name):
    # Published: a few to 15 USD a prototype.
    assert 3 < bill_of_materials(geometry.prototype(name), built(name)).cost < 16


def test_the_files_hold_the_same_bill(bill, tmp_path):
    table, data, text = write_bill(bill, tmp_path / "new")
    rows = list(csv.DictReader(io.StringIO(table.read_text(encoding="utf-8"))))
    assert [row["item"] for row in rows] == [item.item for item in bill.items]
    assert sum(float(row["cost"]) for row in rows) == pytest.approx(
        bill.cost + bill.tooling_cost, abs=0.005 * len(rows)
    )
    read = json.loads(data.read_text(encoding="utf-8"))
    assert read["cost"] == pytest.approx(bill.cost)
    assert {row["price_source"] for row in read["items"]} == {row["price source"] for row in rows} == {"assumed"}
    assert [row["part number"] for row in rows] == [item["part_number"] for item in read["items"]]
    assert [item["count"] for item in read["items"]] == [item.count for item in bill.items]
    assert text.read_text(encoding="utf-8").count("\n") == len(bill.items) + 6  # title, heads, what is lost, sum
    assert sorted(path.name for path in (tmp_path / "new").iterdir()) == ["bill.csv", "bill.json", "bill.txt"]
