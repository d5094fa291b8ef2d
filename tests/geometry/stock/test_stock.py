"""The catalogue: its data are valid, a design is fitted to it, and a user's own parts are checked as designs are."""

import math

import pytest
from refusals import refused

import geometry
from geometry import Kind, Refusal
from geometry.schema.materials import MATERIALS
from geometry.stock import KINDS, Silicone, Sleeve, Spring, StockMicrophone, Tubing, catalogue
from geometry.stock.stock_files import VARIABLE, built_in_parts


@pytest.fixture(scope="module")
def stock():
    return catalogue()


# -- the data that come with the package ----------------------------------------------------------------
def test_every_kind_has_parts_and_every_part_a_source_a_dated_price_and_a_name(stock):
    assert {part.kind for part in stock.parts} == set(KINDS)
    for part in stock.parts:
        assert part.source, part
        assert part.price_date.startswith("20"), part
        assert part.name, part
        assert part.assumed or part.source != "assumed"


def test_a_part_with_a_number_has_a_maker(stock):
    assert [part.name for part in stock.parts if part.part_number and not part.maker] == []


def test_no_part_is_listed_twice(stock):
    rows = [tuple(sorted((key, str(value)) for key, value in part.to_dict().items())) for part in stock.parts]
    assert len(set(rows)) == len(rows)


def test_kinds_that_several_makers_offer_name_several(stock):
    for kind in ("sleeve", "tubing", "sheet", "silicone", "resin", "glue", "microphone"):
        assert len({part.maker for part in stock.listed(kind)} - {""}) >= 2, kind


def test_silicones_make_the_built_in_materials(stock):
    silicones = {name for name in MATERIALS if name.startswith("silicone-")}
    assert {name for part in stock.of(Silicone) for name in part.materials} == silicones


def test_the_noise_of_a_microphone_follows_from_its_ratio_to_94_db():
    # 66 dB(A) leave 28 dB(A) of noise: 20e-6 x 10^(28 / 20) Pa, over the square root of the weighted bandwidth.
    part = next(each for each in built_in_parts() if each.part_number == "SPH1878LR5H-C")
    assert part.noise_density == pytest.approx(20e-6 * 10 ** (28 / 20) / math.sqrt(12467), rel=1e-3)


def test_what_a_microphone_determines_makes_a_valid_design(stock):
    design = geometry.prototype("array-2x6")
    for part in stock.of(StockMicrophone):
        changed = design.with_values(part.values)
        assert changed.microphone.model == part.part_number
        assert changed.microphone.package_length == part.length
        if part.overload is not None:  # dB SPL of a sine, whose peak is stated
            peak = math.sqrt(2) * 20e-6 * 10 ** (part.overload / 20)
            assert changed.microphone.overload == pytest.approx(peak, rel=2e-3)


# -- sleeves and tubing over a spring -------------------------------------------------------------------
def row(kind, **values):
    return kind(**{"price": 1.0, "price_date": "2025", "source": "assumed", **values})


def test_a_sleeve_keeps_its_cross_section_as_it_shrinks():
    sleeve = row(Sleeve, supplied_diameter=1.2, recovered_diameter=0.6, recovered_wall=0.4)
    area = math.pi / 4 * (1.4**2 - 0.6**2)
    outside = sleeve.outside_over(0.9)
    assert math.pi / 4 * (outside**2 - 0.9**2) == pytest.approx(area, rel=1e-3)
    assert sleeve.outside_over(0.6) == pytest.approx(1.4)


@pytest.mark.parametrize("spring", [0.5, 1.19, 2.0])
def test_a_sleeve_that_is_too_wide_or_too_narrow_does_not_go_over_a_spring(spring):
    assert row(Sleeve, supplied_diameter=1.2, recovered_diameter=0.6, recovered_wall=0.4).outside_over(spring) is None


@pytest.mark.parametrize(("spring", "outside"), [(0.7, 1.2), (0.8, 1.2), (0.81, None), (0.6, None)])
def test_a_spring_slides_into_a_tubing_with_little_gap(spring, outside):
    assert row(Tubing, inner_diameter=0.8, outer_diameter=1.2).outside_over(spring) == outside


# -- sizes of fields ------------------------------------------------------------------------------------
def test_bores_and_wires_are_those_of_springs_that_a_sheath_goes_over(stock):
    pairs = {(part.bore, part.wire_diameter) for part in stock.of(Spring)}
    assert set(stock.sizes("tube.inner_diameter")) == {bore for bore, _ in pairs}
    assert set(stock.sizes("tube_kinds.up.wire_diameter")) == {wire for _, wire in pairs}
    assert stock.sizes("lines.0.tube.spring_outer_diameter")[:3] == (0.5, 0.6, 0.7)
    assert stock.sizes("membrane.thickness") == stock.sizes("point_kinds.thin.membrane_thickness")
    assert "ICS-40720" in stock.sizes("microphone.model")
    assert stock.sizes("tube.length") == ()


def test_outsides_at_hand_are_those_over_the_spring_of_the_design(stock):
    design = geometry.prototype("array-2x6")
    over = stock.sizes("tube.outer_diameter", design)
    assert set(over) < set(stock.sizes("tube.outer_diameter"))
    assert all(value > 0.6 for value in over)


def test_a_smooth_bore_is_that_of_a_tubing(stock):
    smooth = geometry.prototype("array-2x6").with_values({"tube.bore": "smooth"})
    bores = {round(part.inner_diameter, 4) for part in stock.of(Tubing)}
    assert set(stock.sizes("tube.inner_diameter", smooth)) == bores


@pytest.mark.parametrize(
    ("field", "value", "size"),
    [("tube.spring_outer_diameter", 0.76, 0.8), ("tube.inner_diameter", 0.45, 0.44), ("membrane.thickness", 0.52, 0.5)],
)
def test_the_nearest_part_has_the_nearest_size(stock, field, value, size):
    part = stock.nearest(field, value)
    own = {"tube.inner_diameter": "bore", "tube.spring_outer_diameter": "outer_diameter"}.get(field, "thickness")
    assert getattr(part, own) == pytest.approx(size)


def test_a_field_that_is_printed_has_no_nearest_part(stock):
    with refused(Kind.UNKNOWN, "field", "resonator.cavity_height"):
        stock.nearest("resonator.cavity_height", 2.0)


# -- a design of parts ----------------------------------------------------------------------------------
@pytest.mark.parametrize("name", ["array-2x6", "glove", "large-area-64"])
def test_prototypes_of_the_paper_are_made_of_stock_as_they_are(stock, name):
    fit = stock.fit(name)
    assert fit.bought
    assert fit.design == geometry.prototype(name)
    assert fit.parts["tube.spring"].outer_diameter == pytest.approx(fit.design.tube.spring_outer_diameter)


@pytest.mark.parametrize("name", ["fingertip-3x4", "fingertip-4x6"])
def test_springs_of_a_fingertip_are_made_to_order_and_the_nearest_is_named(stock, name):
    fit = stock.fit(name)
    assert fit.missing == ("tube.spring_outer_diameter",)
    assert fit.nearest["tube.spring_outer_diameter"].outer_diameter == 0.5
    assert fit.design == geometry.prototype(name)


def test_a_bore_beside_the_sizes_becomes_the_nearest(stock):
    odd = geometry.prototype("array-2x6").with_values({"tube.inner_diameter": 0.4487, "membrane.thickness": 0.4612})
    fit = stock.fit(odd)
    assert fit.design.tube.inner_diameter == pytest.approx(0.44)
    assert fit.design.membrane.thickness == 0.5
    assert {change.field for change in fit.changes} == {
        "tube.inner_diameter",
        "tube.outer_diameter",
        "membrane.thickness",
    }
    assert stock.fit(fit.design).bought


def test_a_tube_that_nobody_stated_to_the_microphones_follows():
    design = geometry.prototype("array-2x6")
    alike = design.with_values({"tube.inner_diameter": 0.5}).model_dump()
    del alike["microphone_tube"]
    fit = catalogue().fit(geometry.ArrayDesign(**alike))
    assert fit.design.microphone_tube == fit.design.tube
    assert not any(role.startswith("microphone_tube") for role in fit.parts)


def test_unknown_microphones_and_materials_are_missing(stock):
    own = geometry.prototype("array-2x6").material("silicone-shore-a-20")
    odd = geometry.prototype("array-2x6").with_values(
        {"microphone.model": "HOME-MADE-1", "materials": {"mine": own}, "membrane.material": "mine"}
    )
    fit = stock.fit(odd)
    assert fit.missing == ("membrane.material", "microphone.model")
    assert "silicone-shore-a-20" in fit.nearest["membrane.material"].materials
    assert not fit.bought
    assert [each["field"] for each in fit.to_dict()["missing"]] == list(fit.missing)


def test_a_smooth_tube_is_a_tubing_without_a_spring(stock):
    smooth = {
        "tube.bore": "smooth",
        "tube.inner_diameter": 0.45,
        "tube.wire_diameter": 0.05,
        "tube.outer_diameter": 0.8,
    }
    fit = stock.fit(geometry.prototype("array-2x6").with_values(smooth))
    tubing = fit.parts["tube.tubing"]
    assert (fit.design.tube.inner_diameter, fit.design.tube.outer_diameter) == (
        tubing.inner_diameter,
        pytest.approx(tubing.outer_diameter),
    )
    assert "tube.spring" not in fit.parts


# -- a user's own parts ---------------------------------------------------------------------------------
OWN = """
replace = ["spring"]

[[spring]]
maker = "the workshop"
outer_diameter = 0.55
wire_diameter = 0.07
price = 12.0
price_date = "2026-11-02"
source = "measured"
"""


def test_own_parts_stand_beside_those_of_the_package_or_in_their_place(tmp_path, monkeypatch):
    (tmp_path / "mine.toml").write_text(OWN, encoding="utf-8")
    for given in (tmp_path, tmp_path / "mine.toml"):
        own = catalogue(given)
        assert own.sizes("tube.spring_outer_diameter") == (0.55,)
        assert own.sizes("membrane.thickness") == catalogue().sizes("membrane.thickness")
    monkeypatch.setenv(VARIABLE, str(tmp_path))
    assert catalogue().sizes("tube.spring_outer_diameter") == (0.55,)


def test_a_changed_file_is_read_again(tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text(OWN, encoding="utf-8")
    assert catalogue(path).sizes("tube.wire_diameter") == (0.07,)
    path.write_text(OWN.replace("0.07", "0.061"), encoding="utf-8")
    assert catalogue(path).sizes("tube.wire_diameter") == (0.061,)


@pytest.mark.parametrize(
    ("old", "new", "kind", "field", "value"),
    [
        ("0.07", "0.5", Kind.CONFLICT, "spring.0.outer_diameter", 0.55),
        ("0.07", "-1.0", Kind.OUT_OF_RANGE, "spring.0.wire_diameter", -1.0),
        ("wire_diameter", "wire_diametre", Kind.UNKNOWN, "spring.0.wire_diametre", 0.07),
        ('source = "measured"', "", Kind.MISSING, "spring.0.source", Refusal.NOT_GIVEN),
        ('"2026-11-02"', '"yesterday"', Kind.OUT_OF_RANGE, "spring.0.price_date", "yesterday"),
        ('"spring"]', '"rope"]', Kind.OUT_OF_RANGE, "replace.0", "rope"),
    ],
)
def test_faults_of_a_file_name_it_and_the_field(tmp_path, old, new, kind, field, value):
    path = tmp_path / "mine.toml"
    path.write_text(OWN.replace(old, new, 1), encoding="utf-8")
    with refused(kind, field, value, file=path):
        catalogue(path)


def test_places_without_parts_are_refused(tmp_path):
    with refused(Kind.MISSING, file=tmp_path):
        catalogue(tmp_path)
    (tmp_path / "empty.toml").write_text("", encoding="utf-8")
    with refused(Kind.MISSING, file="empty.toml"):
        catalogue(tmp_path)
    with refused(Kind.MISSING, file="none.toml"):
        catalogue(tmp_path / "none.toml")


# -- one field of a design ------------------------------------------------------------------------------
@pytest.mark.parametrize("name", ["array-2x6", "line-2", "glove"])
@pytest.mark.parametrize("field", ["inner_diameter", "wire_diameter", "outer_diameter"])
def test_each_size_of_a_tube_brings_the_parts_that_make_it(stock, name, field):
    design = geometry.prototype(name)
    made = 0
    for size in stock.sizes(f"tube.{field}", design):
        values = stock.bought_values(f"tube.{field}", size, design)
        assert values[f"tube.{field}"] == pytest.approx(size, abs=1e-3)
        try:
            changed = design.with_values(values)
        except Refusal:
            continue  # too wide for its cavities
        made += 1
        fit = stock.fit(changed)
        assert not [change for change in fit.changes if change.field.startswith("tube.")], (values, fit.changes)
        assert not fit.missing
    assert made > 3


def test_a_spring_made_to_order_stays_where_its_sheath_is_chosen(stock):
    design = geometry.prototype("fingertip-3x4")
    size = stock.sizes("tube.outer_diameter", design)[0]
    values = stock.bought_values("tube.outer_diameter", size, design)
    assert values["tube.outer_diameter"] == pytest.approx(size)
    assert values["tube.inner_diameter"] == design.tube.inner_diameter


def test_a_thickness_is_that_of_a_sheet_and_other_fields_are_refused(stock):
    design = geometry.prototype("array-2x6")
    assert stock.bought_values("membrane.thickness", 0.47, design) == {"membrane.thickness": 0.5}
    with refused(Kind.UNKNOWN, "field", "tube.length"):
        stock.bought_values("tube.length", 12.0, design)
