"""Design files: what is read is what was written, and what is wrong is refused in one line."""

from __future__ import annotations

import math
import tomllib
from copy import deepcopy
from functools import partial
from pathlib import Path
from typing import Any

import pytest
import tomlkit
from hypothesis import given, strategies as st
from refusals import check_messages, refused
from rings import rectangle, triangle

import geometry
from acoustic_fem.duct.coil_bore import CoilBore
from geometry.design.array_design import ArrayDesign
from geometry.design.changes import changed
from geometry.design.design_file import prototype_text, read_completed, read_design, write_design
from geometry.ground.refusal import Kind, Refusal
from geometry.schema.declared_fields import fields_of
from geometry.schema.field_errors import DesignError, UnknownField
from geometry.schema.materials import MATERIALS, Material, blend_modulus, youngs_modulus_from_shore_a
from geometry.schema.part_fields import Tube

DELETE = object()


def altered_text(name: str, value: Any, prototype: str = "array-2x6") -> str:
    """File of a prototype with one key set, or taken away."""
    data = tomllib.loads(prototype_text(prototype))
    *way, last = name.split(".")
    place: Any = data
    for step in way:
        place = place[int(step)] if isinstance(place, list) else place.setdefault(step, {})
    if value is DELETE:
        del place[last]
    else:
        place[last] = value
    return tomlkit.dumps(data)


# -- wrong designs ----------------------------------------------------------------------------------
NOT_ALLOWED = {
    Kind.OUT_OF_RANGE: [
        ("resonator.cavity_diameter", 0.1),
        ("resonator.cavity_diameter", 51),
        ("resonator.cavity_height", math.inf),
        ("resonator.port_height", -1.0),
        ("membrane.thickness", 0.0),
        ("tube.length", 2000.0),
        ("tube.wire_diameter", -0.08),
        ("tube.sheath_wall", -0.1),
        ("microphone.vent_corner", 0),
        ("microphone.sensitivity", 3.0),
        ("microphone.noise_density", 0.0),
        ("air.temperature", 293.15),
        ("air.humidity", 50),
        ("air.pressure", 101.325),
        ("lines.0.points", 0),
        ("layout.kind", "serpentin"),
        ("layout.kind", 3),
        ("printing.process", "ink"),
        ("target.size", [30.0]),
        ("target.force", 0.0),
        ("target.budget", -1.0),
        ("mold.kind", "three-part"),
        ("name", ""),
        ("name", "a/b"),
        ("microphones", []),
        ("lines", []),
        ("lines.0.between", ["A"]),
        ("lines.0.between", ["A", "B", "C"]),
    ],
    Kind.WRONG_TYPE: [
        ("resonator.wall_thickness", "2 mm"),
        ("resonator.wall_thickness", True),
        ("membrane.thickness", [0.5]),
        ("tube.spring_outer_diameter", "wide"),
        ("microphone.model", 1878),
        ("lines.0.points", 2.5),
        ("lines.0.points", True),
        ("microphones", "AB"),
        ("lines", 3),
        ("tube", 3),
    ],
    Kind.UNKNOWN: [
        ("tube.lenght", 3.0),
        ("tube.spring_diameter", 3.0),
        ("lines.0.pionts", 3),
        ("resonators", {}),
        ("colour", "red"),
    ],
    Kind.CONFLICT: [("tube.spring_outer_diameter", 0.16)],
}
MISSING = [("tube.length", DELETE), ("tube", DELETE), ("name", DELETE), ("lines.0.points", DELETE)]


@pytest.mark.parametrize(
    ("kind", "field", "value"), [(kind, *case) for kind, cases in NOT_ALLOWED.items() for case in cases]
)
def test_a_value_that_is_not_allowed_is_refused_with_its_field(kind: Kind, field: str, value: Any) -> None:
    with refused(kind, field, value, file="design.toml", error=DesignError):
        read_design(altered_text(field, value), "design.toml")


@pytest.mark.parametrize(("field", "value"), MISSING)
def test_a_field_that_is_missing_is_named(field: str, value: Any) -> None:
    with refused(Kind.MISSING, field, Refusal.NOT_GIVEN, error=DesignError):
        read_design(altered_text(field, value))


def test_a_value_that_is_no_number_at_all_is_refused() -> None:
    with refused(Kind.OUT_OF_RANGE, "resonator.cavity_height"):
        read_design(altered_text("resonator.cavity_height", math.nan))


def test_a_field_is_given_or_what_it_follows_from() -> None:
    with refused(Kind.CONFLICT, "tube.spring_outer_diameter", 0.6):
        read_design(altered_text("tube.inner_diameter", 0.5))
    with refused(Kind.OUT_OF_RANGE, "tube.inner_diameter", pytest.approx(0.04)) as found:
        read_design(altered_text("tube.spring_outer_diameter", 0.2))
    assert "spring_outer_diameter - 2 x wire_diameter" in found.value.allowed


def test_a_misspelt_required_key_is_one_problem_not_two() -> None:
    with refused(Kind.UNKNOWN, "resonator.cavity_hight", 2.5, error=DesignError) as found:
        read_design(prototype_text("array-2x6").replace("cavity_height", "cavity_hight"))
    assert "'cavity_height'" in found.value.remedy
    assert len(found.value.problems) == 1


def test_further_problems_are_counted_in_the_message_and_kept() -> None:
    data = tomllib.loads(prototype_text("array-2x6"))
    data["membrane"]["thickness"] = -1.0
    data["air"]["humidity"] = 2.0
    with refused(Kind.OUT_OF_RANGE, error=DesignError) as found:
        read_design(tomlkit.dumps(data), "mine.toml")
    assert str(found.value).endswith("(and 1 more problem)")
    assert [(each.file, each.field, each.value) for each in found.value.problems] == [
        ("mine.toml", "membrane.thickness", -1.0),
        ("mine.toml", "air.humidity", 2.0),
    ]


NARROW = {"length": 12.5, "inner_diameter": 0.5, "outer_diameter": 0.4, "wire_diameter": 0.05}
#: Changes of a prototype, the field at which they do not go together, and its value.
IMPOSSIBLE: list[tuple[dict[str, Any], str, Any]] = [
    ({"tube.inner_diameter": 0.9, "tube.outer_diameter": 0.55}, "tube.inner_diameter", 0.9),
    ({"tube.wire_diameter": 0.3}, "tube.wire_diameter", 0.3),
    ({"membrane.rim_width": 2.5}, "membrane.rim_width", 2.5),
    ({"membrane.thickness": 6.1}, "membrane.thickness", 6.1),
    ({"membrane.thickness": 0.05, "resonator.cavity_diameter": 20.0}, "membrane.thickness", 0.05),
    ({"membrane.thickness": 5.0, "membrane.rim_width": 0.2}, "membrane.rim_width", 0.2),
    ({"tube.outer_diameter": 2.6}, "tube.outer_diameter", 2.6),
    ({"tube.outer_diameter": 2.3}, "resonator.port_height", 1.25),
    ({"resonator.port_height": 0.1}, "resonator.port_height", 0.1),
    ({"resonator.port_height": 2.2}, "resonator.port_height", 2.2),
    ({"resonator.cavity_diameter": 0.85}, "tube.inner_diameter", 0.44),
    ({"tube.length": 1.5}, "tube.length", 1.5),
    ({"tube.length": 4.0}, "tube.length", 4.0),
    ({"microphone_tube.length": 3.0}, "microphone_tube.length", 3.0),
    ({"microphone_tube.inner_diameter": 1.2, "microphone_tube.outer_diameter": 1.4},
     "microphone_tube.inner_diameter", 1.2),
    ({"microphone_tube.outer_diameter": 1.6}, "microphone_tube.outer_diameter", 1.6),
    ({"printing.port_lip": 1.9}, "printing.port_lip", 1.9),
    ({"microphone.sound_hole_diameter": 1.9}, "microphone.sound_hole_diameter", 1.9),
    ({"layout.pitch": 9.0}, "layout.pitch", 9.0),
    ({"layout.pitch": 19.0}, "layout.pitch", 19.0),
    ({"layout.kind": "ring"}, "layout.kind", "ring"),
    ({"microphones": ["A", "A"]}, "microphones", ["A", "A"]),
    ({"microphones": ["A", "B", "C"]}, "microphones", Refusal.NOT_GIVEN),
    ({"lines.0.between": ["A", "A"]}, "lines.0.between", ["A", "A"]),
    ({"lines": [{"between": ["A", "B"], "points": 6}] * 2}, "lines", Refusal.NOT_GIVEN),
    ({"lines.0.tube": NARROW}, "lines.0.tube.inner_diameter", 0.5),
]  # fmt: skip
NOT_KNOWN = {"membrane.material": "rubber", "printing.material": "steel", "lines.0.between": ["A", "Z"]}


def change(values: dict[str, Any]) -> ArrayDesign:
    return geometry.prototype("array-2x6").with_values(values)


@pytest.mark.parametrize(("values", "field", "value"), IMPOSSIBLE)
def test_fields_that_do_not_go_together_are_refused_by_name(values: dict[str, Any], field: str, value: Any) -> None:
    with refused(Kind.CONFLICT, field, value, file="array-2x6", error=DesignError):
        change(values)


@pytest.mark.parametrize(("field", "value"), NOT_KNOWN.items())
def test_names_of_nothing_are_refused(field: str, value: Any) -> None:
    with refused(Kind.UNKNOWN, field, value, file="array-2x6", error=DesignError):
        change({field: value})


def test_messages() -> None:
    wrong = [*(case for cases in NOT_ALLOWED.values() for case in cases), *MISSING]
    check_messages(
        Path(__file__).with_name("messages.txt"),
        {
            **{f"{k + 1}": partial(read_design, altered_text(*case)) for k, case in enumerate(wrong)},
            **{str(values): partial(change, values) for values, _, _ in IMPOSSIBLE},
            **{field: partial(change, {field: value}) for field, value in NOT_KNOWN.items()},
            **{str(law): partial(material, law) for law, *_ in LAWS},
            **{name: partial(change, {name: 1.0}) for name in NO_FIELDS},
            "a field without a table": partial(change, {"lines.0.tube.length": 14.0}),
            "two problems": partial(change, {"air.humidity": 2.0, "tube.length": -1}),
            "no prototype": partial(geometry.prototype, "array"),
            "no design": partial(geometry.resolve_design, "glov"),
            "a ring that does not close": partial(ring_of, (5, 13, 5)),
            "a ring of narrow corners": partial(ring_of, (11, 3, 11)),
        },
    )


def test_microphones_that_no_wiring_connects_are_refused() -> None:
    pairs = [{"between": pair, "points": 3} for pair in (["A", "B"], ["C", "D"])]
    with refused(Kind.CONFLICT, "microphones"):
        geometry.prototype("line-4").with_values({"lines": pairs})


def test_two_lines_between_the_same_microphones_are_refused() -> None:
    with refused(Kind.CONFLICT, "lines.1.between", ["B", "A"]):
        geometry.prototype("glove").with_values({"lines.1.between": ["B", "A"]})


def test_a_ring_joins_neighbours_only() -> None:
    design = rectangle()
    assert design.layout.kind == "ring"
    with refused(Kind.CONFLICT, "lines.0.between", ["A", "C"]):
        design.with_values({"lines.0.between": ["A", "C"]})


def ring_of(points: tuple[int, ...], **values: Any) -> ArrayDesign:
    names = ["A", "B", "C"]
    lines = [{"between": [names[k], names[(k + 1) % 3]], "points": count} for k, count in enumerate(points)]
    return triangle(lines=lines, **values)


def test_a_ring_that_cannot_close_is_refused_with_its_lengths() -> None:
    assert ring_of((5, 7, 5), **{"microphone.chamber_diameter": 2.0}).point_count == 17
    # 21 mm from point to point, and 18.9 mm at each end: 289.8 mm against 243.6 mm
    with refused(Kind.CONFLICT, "lines.1"):
        ring_of((5, 13, 5))
    assert ring_of((5, 13, 5), **{"layout.kind": "serpentine"}).point_count == 23


def test_sockets_must_fit_into_the_corner_of_a_ring() -> None:
    # Two sides of 247.8 mm and one of 79.8 mm: A = 2 asin(39.9 / 247.8) at A,
    # and 2 ((0.05 + 0.6 cos(A / 2)) / sin(A / 2) - 0.5) mm.
    with refused(Kind.CONFLICT, "microphone.chamber_diameter", 1.8) as found:
        ring_of((11, 3, 11))
    assert found.value.allowed.startswith("at least 6.976 mm for the ports of the 2 lines that end at 'A'")
    assert ring_of((11, 3, 11), **{"microphone.chamber_diameter": 7.0}).microphone.chamber_diameter == 7.0


@pytest.mark.parametrize(("diameter", "thin", "thick"), [(6.0, 0.03, 6.0), (7.3, 0.0365, 7.3), (50.0, 0.25, 10.0)])
def test_membranes_within_the_rules_are_those_that_can_be_solved(diameter: float, thin: float, thick: float) -> None:
    from acoustic_fem.membrane.design_discs import design_disc

    cavity = {"resonator.cavity_diameter": diameter, "resonator.wall_thickness": 2.0, "membrane.rim_width": 1.5}
    for thickness in (max(thin, 0.05), thick):
        design = geometry.prototype("array-2x6").with_values({**cavity, "membrane.thickness": thickness})
        assert design_disc(design).static_compliance > 0


def test_the_widest_rim_that_can_be_solved_is_beyond_every_rim_that_is_allowed() -> None:
    limits = {field.name: field.allowed for field in fields_of(ArrayDesign)}
    assert limits["membrane.rim_width"] == "between 0.2 and 20 mm"
    assert limits["resonator.cavity_diameter"] == "between 0.8 and 50 mm"
    assert 20 <= 50 * 0.8 / 2


def test_sockets_of_many_lines_must_fit_around_a_chamber() -> None:
    names = [f"M{k}" for k in range(10)]
    star = [{"between": ["M0", name], "points": 1} for name in names[1:]]
    with refused(Kind.CONFLICT, "microphone.chamber_diameter", 1.9):
        geometry.prototype("array-2x6").with_values({"microphones": names, "lines": star})


anything = st.recursive(
    st.one_of(
        st.none(),
        st.booleans(),
        st.integers(),
        st.integers(10**400, 10**401),
        st.floats(),
        st.text(max_size=8),
        st.dates(),
    ),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=8), inner, max_size=3),
    max_leaves=4,
)


@given(st.data())
def test_whatever_stands_at_a_field_the_design_is_valid_or_refused_in_one_line(data: st.DataObject) -> None:
    design = geometry.prototype("large-area-64")
    names = [
        field.name.replace("*", "1") for field in fields_of(ArrayDesign) if not field.name.startswith("materials.")
    ]
    name = data.draw(st.sampled_from([name for name in names if "1.microphone_tube." not in name]))
    value = data.draw(anything)
    found: DesignError | None = None
    try:
        changed = design.with_values({name: value})
    except DesignError as error:
        found = error
    if found is not None:
        assert found.file == "large-area-64"
        assert "\n" not in str(found)
        assert len(str(found)) < 500
    else:
        assert read_design(write_design(changed)) == changed


# -- sections made in Python ------------------------------------------------------------------------
def test_a_section_made_in_python_is_refused_by_its_own_fields() -> None:
    with refused(Kind.OUT_OF_RANGE, "length", -1, error=DesignError):
        Tube(length=-1, inner_diameter=0.44, outer_diameter=0.9, wire_diameter=0.08)
    with refused(Kind.OUT_OF_RANGE, "poisson_ratio", 0.5, error=DesignError):
        Material(youngs_modulus=1.0, poisson_ratio=0.5, density=1000.0, loss_factor=0.1, source="test")


def test_an_array_made_in_python_is_refused_too() -> None:
    fields = dict(geometry.prototype("array-2x6"))
    with refused(Kind.CONFLICT, "microphones", error=DesignError):
        ArrayDesign(**(fields | {"microphones": ("A", "B", "C")}))
    with refused(Kind.MISSING, "tube.length", error=DesignError):
        ArrayDesign(**(fields | {"tube": {"inner_diameter": 0.4, "outer_diameter": 0.9, "wire_diameter": 0.05}}))


def test_a_tube_follows_from_spring_and_sheath() -> None:
    tube = Tube.model_validate(
        {"length": 12.5, "spring_outer_diameter": 0.6, "wire_diameter": 0.08, "sheath_wall": 0.15}
    )
    assert tube.inner_diameter == 0.44
    assert tube.outer_diameter == 0.9
    assert tube.spring_outer_diameter == pytest.approx(0.6)


# -- files ------------------------------------------------------------------------------------------
@pytest.mark.parametrize(
    ("content", "kind", "field"),
    [(prototype_text("array-2x6").encode()[:900], Kind.MISSING, "tube.inner_diameter"), (b"", Kind.MISSING, "name")],
)
def test_a_file_that_is_cut_short_names_what_is_missing(content: bytes, kind: Kind, field: str, tmp_path: Path) -> None:
    (tmp_path / "cut.toml").write_bytes(content)
    with refused(kind, field, file=tmp_path / "cut.toml", error=DesignError):
        geometry.load_design(tmp_path / "cut.toml")


def test_a_design_is_named_by_prototype_or_by_file(tmp_path: Path) -> None:
    design = geometry.prototype("glove")
    geometry.save_design(design, tmp_path / "mine.toml")
    assert geometry.resolve_design("glove") == design
    assert geometry.resolve_design(tmp_path / "mine.toml") == design
    with refused(Kind.UNKNOWN, file="glov", error=DesignError):
        geometry.resolve_design("glov")
    with refused(Kind.MISSING, file="other.toml", error=DesignError):
        geometry.resolve_design("other.toml")
    with refused(Kind.UNKNOWN, "prototype", "array", error=DesignError):
        geometry.prototype("array")


def test_saving_leaves_the_whole_file_or_the_old_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "design.toml"
    first = geometry.prototype("array-2x6")
    geometry.save_design(first, path)
    monkeypatch.setattr(
        "geometry.ground.whole_files.os.fsync", lambda _: (_ for _ in ()).throw(OSError(28, "No space left"))
    )
    with refused(Kind.UNREADABLE, file=path, error=DesignError):
        geometry.save_design(first.with_values({"tube.length": 20.0}), path)
    monkeypatch.undo()
    assert geometry.load_design(path) == first
    assert [entry.name for entry in tmp_path.iterdir()] == ["design.toml"]


def test_saving_into_a_missing_folder_is_one_line(tmp_path: Path) -> None:
    with refused(Kind.UNREADABLE, file="design.toml", error=DesignError):
        geometry.save_design(geometry.prototype("glove"), tmp_path / "none" / "design.toml")


def test_a_written_file_gives_every_unit() -> None:
    lines = write_design(geometry.prototype("array-2x6")).splitlines()
    assert "cavity_diameter = 6.0 # mm" in lines
    assert "noise_density = 5e-06 # Pa/sqrt(Hz)" in lines
    assert "points = 12" in lines


size = st.floats(1.2, 40.0)


@st.composite
def designs(draw: st.DrawFn) -> ArrayDesign:
    """Valid designs far from the prototypes, with every digit a float can have."""
    tubes = [
        {
            "length": draw(st.floats(20.0, 1000.0)),
            "inner_diameter": draw(st.floats(0.05, 0.6)),
            "outer_diameter": draw(st.floats(0.8, 0.9)),
            "wire_diameter": draw(st.floats(0.01, 0.1)),
        }
        for _ in range(3)
    ]
    cavity = draw(size)
    thickness = draw(st.floats(max(0.05, 0.01 * cavity / 2), min(10.0, 2 * cavity / 2)))
    values: dict[str, Any] = {
        "description": draw(st.text(st.characters(codec="utf-8", exclude_categories=("Cs", "Cc")), max_size=60)),
        "resonator.cavity_diameter": cavity,
        "resonator.cavity_height": draw(st.floats(1.5, 20.0)),
        "resonator.wall_thickness": draw(st.floats(1.5, 3.0)),
        "membrane.material": "own.mix",
        "membrane.thickness": thickness,
        "membrane.rim_width": draw(st.floats(max(0.2, 0.05 * thickness), 1.5)),
        "microphone.noise_density": draw(st.floats(1e-12, 1.0)),
        "lines.0.points": draw(st.integers(1, 1000)),
        "lines.0.tube": draw(st.sampled_from([None, tubes[2]])),
        "tube": tubes[0],
        "microphone_tube": tubes[1],
        "air.temperature": draw(st.floats(-20.0, 60.0)),
        "materials": {
            "own.mix": {
                "youngs_modulus": draw(st.floats(1e-3, 1e5)),
                "poisson_ratio": draw(st.floats(0.3, 0.4999)),
                "density": draw(st.floats(500.0, 5000.0)),
                "loss_factor": draw(st.floats(0.0, 1.0)),
                "source": "drawn",
            }
        },
    }
    return geometry.prototype("array-2x6").with_values(values)


@given(designs())
def test_a_written_design_reads_back_exactly(design: ArrayDesign) -> None:
    text = write_design(design)
    again = read_design(text)
    assert again == design
    assert write_design(again) == text


# -- changed copies ---------------------------------------------------------------------------------
def test_a_changed_copy_differs_in_that_field_only() -> None:
    design = rectangle()
    changed = design.with_values({"lines.1.tube.length": 20.0, "lines.0.points": 7, "air.pressure": 9e4})
    assert changed.lines[1].tube.length == 20.0
    assert changed.point_count == 64 - 9
    assert changed.with_values({"lines.1.tube.length": 14.0, "lines.0.points": 16, "air.pressure": 101325.0}) == design


def test_a_change_leaves_the_tables_it_was_made_from_as_they_were() -> None:
    before = geometry.prototype("array-2x6").model_dump()
    kept = deepcopy(before)
    copy = changed(before, {"tube.inner_diameter": 0.5, "lines.0.points": 6, "lines.0.between": ["B", "A"]}, "array")
    assert before == kept
    assert copy["lines"][0] == {**kept["lines"][0], "points": 6, "between": ["B", "A"]}
    assert copy["tube"] == {**kept["tube"], "inner_diameter": 0.5}


def test_a_changed_spring_changes_the_bore() -> None:
    changed = geometry.prototype("array-2x6").with_values({"tube.spring_outer_diameter": 0.5})
    assert changed.tube.inner_diameter == pytest.approx(0.34)
    assert changed.tube.outer_diameter == 0.9


def test_an_optional_field_goes_back_to_its_default() -> None:
    assert geometry.prototype("fingertip-3x4").with_values({"layout.pitch": None}).layout.pitch is None


NO_FIELDS = ["tube.inner_diametre", "lines.7.points", "lines.x", "tube.length.x", "tube.width", "x"]


@pytest.mark.parametrize("name", NO_FIELDS)
def test_a_change_of_an_unknown_field_is_refused(name: str) -> None:
    with refused(Kind.UNKNOWN, name, file="array-2x6", error=UnknownField):
        change({name: 1.0})


def test_a_field_of_a_table_that_is_not_given_asks_for_the_whole_table() -> None:
    with refused(Kind.MISSING, "lines.0.tube", file="array-2x6", error=UnknownField):
        change({"lines.0.tube.length": 14.0})


def test_a_completed_design_does_not_need_the_built_in_materials(monkeypatch: pytest.MonkeyPatch) -> None:
    design = geometry.prototype("fingertip-3x4").completed()
    assert set(design.materials) == {"silicone-blend-5-1-shore-a-0-5", "photopolymer-resin"}
    text = write_design(design)
    monkeypatch.setattr("geometry.design.design_rules.MATERIALS", {})
    monkeypatch.setattr("geometry.schema.array_fields.MATERIALS", {})
    assert read_design(text).material(design.membrane.material) == MATERIALS[design.membrane.material]


# -- fields and materials ---------------------------------------------------------------------------
def test_every_field_is_described_and_every_length_has_its_unit() -> None:
    fields = list(fields_of(ArrayDesign))
    assert len({field.name for field in fields}) == len(fields) > 60
    for field in fields:
        assert field.description, field.name
        if field.name.endswith(("diameter", "height", "thickness", "length", "width", "pitch")):
            assert field.unit == "mm", field.name
        if field.kind == "a number":
            assert field.allowed, field.name


RELAXATIONS = {"relaxation_times": [1.0], "relaxation_moduli": [1.0]}
LAWS: list[tuple[dict[str, Any], Kind, str]] = [
    ({}, Kind.MISSING, "loss_factor"),
    ({"loss_factor": 0.1, "relaxation_times": [1.0]}, Kind.CONFLICT, "relaxation_times"),
    ({"law": "prony"}, Kind.MISSING, "relaxation_times"),
    ({"law": "prony", **RELAXATIONS, "relaxation_moduli": [1.0, 2.0]}, Kind.MISMATCH, "relaxation_moduli"),
    ({"law": "prony", **RELAXATIONS, "loss_factor": 0.1}, Kind.CONFLICT, "loss_factor"),
    ({"law": "prony", **RELAXATIONS, "relaxation_times": [-1.0]}, Kind.OUT_OF_RANGE, "relaxation_times.0"),
]


def material(law: dict[str, Any]) -> Material:
    return Material(**{"youngs_modulus": 1.0, "poisson_ratio": 0.49, "density": 1000.0, "source": "test", **law})


@pytest.mark.parametrize(("law", "kind", "field"), LAWS)
def test_the_law_of_a_material_is_complete_or_refused(law: dict[str, Any], kind: Kind, field: str) -> None:
    with refused(kind, field, error=DesignError):
        material(law)


def test_a_table_of_relaxations_is_written_and_read() -> None:
    table = {"youngs_modulus": 1.0, "poisson_ratio": 0.49, "density": 1070.0, "source": "a test", "law": "prony"}
    table |= {"relaxation_times": [0.1, 0.01], "relaxation_moduli": [0.2, 0.1]}
    design = geometry.prototype("array-2x6").with_values({"materials.mine": table, "membrane.material": "mine"})
    again = read_design(write_design(design))
    assert again == design
    assert again.material("mine").relaxation_times == (0.1, 0.01)
    assert again.material("mine").law_in_words == "E = 1 MPa after long rest, 2 relaxations"


def test_gent_moduli_are_the_published_ones() -> None:
    published = {0: 0.157, 5: 0.278, 30: 1.14}  # MPa: physics notes after Gent (1958)
    for shore, modulus in published.items():
        assert youngs_modulus_from_shore_a(shore) == pytest.approx(modulus, rel=5e-3)
        assert MATERIALS[f"silicone-shore-a-{shore}"].youngs_modulus == pytest.approx(modulus, rel=5e-3)


def test_a_blend_lies_between_its_parts_and_hardness_out_of_range_is_refused() -> None:
    assert blend_modulus(0.157, 0.278, 1.0) == pytest.approx(0.157)
    assert blend_modulus(0.157, 0.278, 0.0) == pytest.approx(0.278)
    assert 0.157 < blend_modulus(0.157, 0.278, 5 / 6) < 0.278
    with refused(Kind.OUT_OF_RANGE, "fraction_of_first", 1.5):
        blend_modulus(1.0, 2.0, 1.5)
    with refused(Kind.OUT_OF_RANGE, "shore_a", 95):
        youngs_modulus_from_shore_a(95)


# -- bores ------------------------------------------------------------------------------------------
def test_a_completed_design_comes_back_without_built_in_materials_and_an_older_one_is_refused() -> None:
    design = rectangle().with_values({"tube_kinds": {"own": geometry.prototype("line-2").tube}})
    text = write_design(design.completed())
    assert read_completed(text, "a library") == design
    older = "\n".join(line for line in text.splitlines() if not line.startswith("bore ="))
    with pytest.raises(DesignError, match=r"a library: tube\.bore is missing"):
        read_completed(older, "a library")


@pytest.mark.parametrize("wire", [0.02, 0.08, 0.15, 0.21])
def test_air_passes_the_turns_of_a_spring_as_a_slightly_wider_bore(wire: float) -> None:
    tube = Tube(length=12.5, inner_diameter=0.44, outer_diameter=1.5, wire_diameter=wire)
    ribbed = CoilBore(tube.spring_outer_diameter, wire)
    assert tube.acoustic_diameter / 0.44 == pytest.approx(ribbed.effective_radius / ribbed.crest_radius, abs=4e-5)
    smooth = tube.model_copy(update={"bore": "smooth"})
    assert (smooth.acoustic_diameter, smooth.acoustic_length(0.3)) == (0.44, 12.5)


def test_lips_and_openings_of_a_coil_bore_have_the_bore_at_its_crests() -> None:
    tube = geometry.prototype("array-2x6").tube
    crests, acoustic = tube.inner_diameter, tube.acoustic_diameter
    opening = 3 * math.pi / 16 * crests**-3  # 1.5 mu / a^3 twice, by 8 mu / pi 2^4
    stated = (tube.length - 0.6) / acoustic**4 + 0.6 / crests**4 + opening
    worth = tube.acoustic_length(0.3) / acoustic**4 + 3 * math.pi / 16 * acoustic**-3
    assert worth == pytest.approx(stated, rel=1e-12)


def test_a_wire_thicker_than_its_bore_counts_as_one_as_thick() -> None:
    tube = Tube(length=12.5, inner_diameter=0.1, outer_diameter=3, wire_diameter=0.1)
    assert tube.acoustic_diameter == pytest.approx(0.10923)
    assert tube.model_copy(update={"wire_diameter": 1.0}).acoustic_diameter == tube.acoustic_diameter
