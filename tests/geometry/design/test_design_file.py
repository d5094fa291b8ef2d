"""Design files: what is read is what was written, and what is wrong is refused in one line."""

from __future__ import annotations

import math
import tomllib
from copy import deepcopy
from pathlib import Path
from typing import Any

import pytest
import tomlkit
from hypothesis import given, strategies as st
from rings import rectangle, triangle

import geometry
from acoustic_fem.duct.coil_bore import CoilBore
from geometry.design.array_design import ArrayDesign
from geometry.design.changes import changed
from geometry.design.design_file import prototype_text, read_completed, read_design, write_design
from geometry.schema.declared_fields import fields_of
from geometry.schema.field_errors import DesignError
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


def refusal(text: str) -> str:
    with pytest.raises(DesignError) as caught:
        read_design(text, "design.toml")
    message = str(caught.value)
    assert "\n" not in message
    assert "pydantic" not in message.lower()
    assert message.startswith("design.toml: ")
    return message.removeprefix("design.toml: ")


# -- wrong designs ----------------------------------------------------------------------------------
OUT_OF_RANGE = [
    ("resonator.cavity_diameter", 0.1, "= 0.1 mm must be between 0.8 and 50 mm"),
    ("resonator.cavity_diameter", 51, "= 51 mm must be between 0.8 and 50 mm"),
    ("resonator.cavity_height", float("nan"), "= nan mm must be a finite number between 0.4 and 50 mm"),
    ("resonator.cavity_height", float("inf"), "= inf mm must be a finite number between 0.4 and 50 mm"),
    ("resonator.wall_thickness", "2 mm", "= '2 mm' must be a number between 0.3 and 20 mm"),
    ("resonator.wall_thickness", True, "= true must be a number between 0.3 and 20 mm"),
    ("resonator.port_height", -1.0, "= -1 mm must be above 0 mm"),
    ("membrane.thickness", 0.0, "= 0 mm must be between 0.05 and 10 mm"),
    ("membrane.thickness", [0.5], "= [0.5] must be a number between 0.05 and 10 mm"),
    ("tube.length", 2000.0, "= 2000 mm must be between 0.5 and 1000 mm"),
    ("tube.wire_diameter", -0.08, "= -0.08 mm must be between 0.01 and 1 mm"),
    ("tube.spring_outer_diameter", "wide", "= 'wide' must be a number above 0 mm"),
    ("tube.spring_outer_diameter", 0.16, "= 0.16 mm must be above 2 x wire_diameter (0.16 mm)"),
    ("tube.sheath_wall", -0.1, "= -0.1 must be a number above 0 mm"),
    ("tube.inner_diameter", 0.5, "spring_outer_diameter = 0.6 must not be given beside inner_diameter"),
    ("microphone.vent_corner", 0, "= 0 Hz must be above 0 and at most 1000 Hz"),
    ("microphone.sensitivity", 3.0, "= 3 dB re 1 V/Pa must be between -80 and 0 dB re 1 V/Pa"),
    ("microphone.noise_density", 0.0, "= 0 Pa/sqrt(Hz) must be above 0 and at most 1 Pa/sqrt(Hz)"),
    ("microphone.model", 1878, "= 1878 must be a text"),
    ("air.temperature", 293.15, "= 293.15 degC must be between -20 and 60 degC"),
    ("air.humidity", 50, "= 50 must be between 0 and 1"),
    ("air.pressure", 101.325, "= 101.325 Pa must be between 50000 and 120000 Pa"),
    ("lines.0.points", 0, "= 0 must be a whole number between 1 and 1000"),
    ("lines.0.points", 2.5, "= 2.5 must be a whole number between 1 and 1000"),
    ("lines.0.points", True, "= true must be a whole number between 1 and 1000"),
    (
        "layout.kind",
        "serpentin",
        "= 'serpentin' must be one of 'serpentine', 'ring', 'area', 'cylinder', 'hand'; did you mean 'serpentine'?",
    ),
    ("layout.kind", 3, "= 3 must be one of 'serpentine', 'ring'"),
    ("printing.process", "ink", "= 'ink' must be one of 'sla-resin', 'dlp-fine', 'fdm', 'mjf'"),
    ("name", "", "= '' must be a text of 1 to 80 characters"),
    ("name", "a/b", "= 'a/b' must be a text of 1 to 80 characters, starting with a letter or digit"),
    ("microphones", [], "= [] must be a list of 2 to 16 entries"),
    ("microphones", "AB", "= 'AB' must be a list of 2 to 16 entries"),
    ("lines", [], "= [] must be a list of at least 1 entries"),
    ("lines", 3, "= 3 must be a list of at least 1 entries"),
    ("tube", 3, "= 3 must be a table of length, inner_diameter, outer_diameter, wire_diameter"),
]


@pytest.mark.parametrize(("field", "value", "rest"), OUT_OF_RANGE)
def test_a_value_out_of_range_is_refused_with_its_field_value_unit_and_range(field: str, value: Any, rest: str) -> None:
    message = refusal(altered_text(field, value))
    assert message.startswith(field.rsplit(".", 1)[0] if field == "tube.inner_diameter" else field)
    assert rest in message


MISSING_OR_UNKNOWN = [
    ("tube.length", DELETE, "tube.length is missing: must be a number between 0.5 and 1000 mm"),
    ("tube", DELETE, "tube is missing: must be a table of length,"),
    ("name", DELETE, "name is missing: must be a text of 1 to 80 characters"),
    ("lines.0.points", DELETE, "lines.0.points is missing: must be a whole number between 1 and 1000"),
    ("tube.lenght", 3.0, "tube.lenght = 3 is not a field of a design; did you mean 'length'?"),
    ("tube.spring_diameter", 3.0, "tube.spring_diameter = 3 is not a field of a design; did you mean"),
    ("lines.0.pionts", 3, "lines.0.pionts = 3 is not a field of a design; did you mean 'points'?"),
    ("resonators", {}, "resonators = {} is not a field of a design; did you mean 'resonator'?"),
    ("colour", "red", "colour = 'red' is not a field of a design; known: layout,"),
    (
        "materials.soft.youngs_modulus",
        1.0,
        "materials.soft.poisson_ratio is missing: must be a number above 0 and",
    ),
]


@pytest.mark.parametrize(("field", "value", "message"), MISSING_OR_UNKNOWN)
def test_a_missing_or_unknown_key_is_named_with_what_belongs_there(field: str, value: Any, message: str) -> None:
    assert refusal(altered_text(field, value)).startswith(message)


def test_a_misspelt_required_key_is_one_problem_not_two() -> None:
    text = prototype_text("array-2x6").replace("cavity_height", "cavity_hight")
    assert refusal(text) == ("resonator.cavity_hight = 2.5 is not a field of a design; did you mean 'cavity_height'?")


def test_a_derived_value_out_of_range_says_what_it_follows_from() -> None:
    message = refusal(altered_text("tube.spring_outer_diameter", 0.2))
    assert message == (
        "tube.inner_diameter = 0.04 mm must be between 0.05 and 5 mm (it is spring_outer_diameter - 2 x wire_diameter)"
    )


def test_further_problems_are_counted_in_the_message_and_kept() -> None:
    data = tomllib.loads(prototype_text("array-2x6"))
    data["membrane"]["thickness"] = -1.0
    data["air"]["humidity"] = 2.0
    with pytest.raises(DesignError) as caught:
        read_design(tomlkit.dumps(data))
    assert str(caught.value).endswith("(and 1 more problem)")
    assert [problem.split(" = ")[0] for problem in caught.value.problems] == [
        "design.toml: membrane.thickness",
        "design.toml: air.humidity",
    ]


IMPOSSIBLE = [
    ({"tube.inner_diameter": 0.9, "tube.outer_diameter": 0.55},
     "tube.inner_diameter = 0.9 mm must be below tube.outer_diameter (0.55 mm)"),
    ({"tube.wire_diameter": 0.3}, "tube.wire_diameter = 0.3 mm must be at most 0.23 mm"),
    ({"membrane.rim_width": 2.5}, "membrane.rim_width = 2.5 mm must be at most resonator.wall_thickness (2 mm)"),
    ({"membrane.thickness": 6.1},
     "membrane.thickness = 6.1 mm must be at most 6 mm, 2 radii of resonator.cavity_diameter (6 mm)"),
    ({"membrane.thickness": 0.05, "resonator.cavity_diameter": 20.0},
     "membrane.thickness = 0.05 mm must be at least 0.1 mm, 0.01 radii of resonator.cavity_diameter (20 mm)"),
    ({"membrane.thickness": 5.0, "membrane.rim_width": 0.2},
     "membrane.rim_width = 0.2 mm must be at least 0.25 mm, a twentieth of membrane.thickness (5 mm)"),
    ({"membrane.material": "rubber"}, "membrane.material = 'rubber' must be one of: photopolymer-resin, silicone-"),
    ({"printing.material": "steel"}, "printing.material = 'steel' must be one of: "),
    ({"tube.outer_diameter": 2.6}, "tube.outer_diameter = 2.6 mm must be at most resonator.cavity_height (2.5 mm)"),
    ({"tube.outer_diameter": 2.3}, "resonator.port_height = 1.25 mm (the default, mid height) must be between"),
    ({"resonator.port_height": 0.1}, "resonator.port_height = 0.1 mm must be between 0.22 and 1.9 mm"),
    ({"resonator.port_height": 2.2}, "resonator.port_height = 2.2 mm must be between 0.22 and 1.9 mm"),
    ({"resonator.cavity_diameter": 0.85}, "tube.inner_diameter = 0.44 mm must be at most half of resonator.cavity_dia"),
    ({"tube.length": 1.5}, "tube.length = 1.5 mm must be at least 1.76 mm"),
    ({"tube.length": 4.0}, "tube.length = 4 mm must be above 4 mm, the two walls it passes through"),
    ({"microphone_tube.length": 3.0}, "microphone_tube.length = 3 mm must be above 3 mm, the two walls"),
    ({"microphone_tube.inner_diameter": 1.2, "microphone_tube.outer_diameter": 1.4},
     "microphone_tube.inner_diameter = 1.2 mm must be at most half of microphone.chamber_diameter (0.95 mm)"),
    ({"microphone_tube.outer_diameter": 1.6}, "microphone_tube.outer_diameter = 1.6 mm must be at most 1.5 mm"),
    ({"printing.port_lip": 1.9}, "printing.port_lip = 1.9 mm must be below"),
    ({"microphone.sound_hole_diameter": 1.9},
     "microphone.sound_hole_diameter = 1.9 mm must be below microphone.chamber_diameter (1.9 mm)"),
    ({"layout.pitch": 9.0}, "layout.pitch = 9 mm is below 10 mm, where shells touch; it must be left out, or 18.5 mm"),
    ({"layout.pitch": 19.0}, "layout.pitch = 19 mm is more than its tubes reach; it must be left out, or 18.5 mm"),
    ({"layout.kind": "ring"}, "layout.kind = 'ring' needs at least 3 microphones"),
    ({"microphones": ["A", "A"]}, "microphones = ['A', 'A'] must be different names"),
    ({"microphones": ["A", "B", "C"]}, "microphones: 'C' is on no line"),
    ({"lines.0.between": ["A", "Z"]}, "lines.0.between = ['A', 'Z'] must name microphones of ['A', 'B']"),
    ({"lines.0.between": ["A", "A"]}, "lines.0.between = ['A', 'A'] must name two different microphones"),
    ({"lines.0.between": ["A"]}, "lines.0.between = ['A'] must have an entry number 1"),
    ({"lines.0.between": ["A", "B", "C"]}, "lines.0.between = ['A', 'B', 'C'] must be a list of 2"),
    ({"lines": [{"between": ["A", "B"], "points": 6}] * 2}, "lines = 2 lines must be at most M(M-1)/2 = 1"),
    ({"lines.0.tube": {"length": 12.5, "inner_diameter": 0.5, "outer_diameter": 0.4, "wire_diameter": 0.05}},
     "lines.0.tube.inner_diameter = 0.5 mm must be below lines.0.tube.outer_diameter (0.4 mm)"),
]  # fmt: skip


@pytest.mark.parametrize(("values", "message"), IMPOSSIBLE)
def test_fields_that_do_not_go_together_are_refused_by_name(values: dict[str, Any], message: str) -> None:
    design = geometry.prototype("array-2x6")
    with pytest.raises(DesignError) as caught:
        design.with_values(values)
    assert str(caught.value).startswith(f"array-2x6: {message}")


def test_microphones_that_no_wiring_connects_are_refused() -> None:
    design = geometry.prototype("line-4")
    pairs = [{"between": pair, "points": 3} for pair in (["A", "B"], ["C", "D"])]
    with pytest.raises(DesignError, match=r"microphones: 'C' cannot be reached from 'A'"):
        design.with_values({"lines": pairs})


def test_two_lines_between_the_same_microphones_are_refused() -> None:
    design = geometry.prototype("glove")
    with pytest.raises(DesignError, match=r"lines\.1\.between = \['B', 'A'\] must be a pair of its own; lines\.0"):
        design.with_values({"lines.1.between": ["B", "A"]})


def test_a_ring_joins_neighbours_only() -> None:
    design = rectangle()
    assert design.layout.kind == "ring"
    with pytest.raises(DesignError, match=r"lines\.0\.between = \['A', 'C'\] must join neighbours"):
        design.with_values({"lines.0.between": ["A", "C"]})


def ring_of(points: tuple[int, ...], **values: Any) -> ArrayDesign:
    names = ["A", "B", "C"]
    lines = [{"between": [names[k], names[(k + 1) % 3]], "points": count} for k, count in enumerate(points)]
    return triangle(lines=lines, **values)


def test_a_ring_that_cannot_close_is_refused_with_its_lengths() -> None:
    assert ring_of((5, 7, 5), **{"microphone.chamber_diameter": 2.0}).point_count == 17
    # 21 mm from point to point, and 18.9 mm at each end
    with pytest.raises(DesignError) as caught:
        ring_of((5, 13, 5))
    assert str(caught.value) == (
        "glove: layout.kind = 'ring': lines.1, 289.8 mm from microphone to microphone, must be shorter than the other "
        "lines together (243.6 mm) for the ring to close"
    )
    assert ring_of((5, 13, 5), **{"layout.kind": "serpentine"}).point_count == 23


def test_sockets_must_fit_into_the_corner_of_a_ring() -> None:
    # Two sides of 247.8 mm and one of 79.8 mm: A = 2 asin(39.9 / 247.8) at A,
    # and 2 ((0.05 + 0.6 cos(A / 2)) / sin(A / 2) - 0.5) mm.
    with pytest.raises(DesignError) as caught:
        ring_of((11, 3, 11))
    assert str(caught.value).startswith("glove: microphone.chamber_diameter = 1.8 mm must be at least 6.976 mm ")
    assert str(caught.value).endswith(
        "mm for the ports of the 2 lines that end at 'A' to fit around it, 18.53 degrees apart "
        "with 0.1 mm of wall between them"
    )
    assert ring_of((11, 3, 11), **{"microphone.chamber_diameter": 7.0}).microphone.chamber_diameter == 7.0


@pytest.mark.parametrize(("diameter", "thin", "thick"), [(6.0, 0.03, 6.0), (7.3, 0.0365, 7.3), (50.0, 0.25, 10.0)])
def test_membranes_within_the_rules_are_those_that_can_be_solved(diameter: float, thin: float, thick: float) -> None:
    from acoustic_fem.membrane.disc import design_disc

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
    with pytest.raises(DesignError, match=r"chamber_diameter = 1\.9 mm must be at least 2\.04 mm .* 9 lines"):
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
    try:
        changed, refused = design.with_values({name: value}), ""
    except DesignError as error:
        changed, refused = None, str(error)
    if changed is None:
        assert refused.startswith("large-area-64: ")
        assert "\n" not in refused
        assert len(refused) < 500
    else:
        assert read_design(write_design(changed)) == changed


# -- sections made in Python ------------------------------------------------------------------------
def test_a_section_made_in_python_is_refused_in_the_same_words() -> None:
    with pytest.raises(DesignError, match=r"^length = -1 mm must be between 0\.5 and 1000 mm$"):
        Tube(length=-1, inner_diameter=0.44, outer_diameter=0.9, wire_diameter=0.08)
    with pytest.raises(DesignError, match=r"^poisson_ratio = 0\.5 must be above 0 and below 0\.5$"):
        Material(youngs_modulus=1.0, poisson_ratio=0.5, density=1000.0, loss_factor=0.1, source="test")


def test_an_array_made_in_python_is_refused_in_the_same_words() -> None:
    fields = dict(geometry.prototype("array-2x6"))
    with pytest.raises(DesignError, match=r"^microphones: 'C' is on no line; the lines must connect all of"):
        ArrayDesign(**(fields | {"microphones": ("A", "B", "C")}))
    with pytest.raises(DesignError, match=r"^tube\.length is missing: must be a number"):
        ArrayDesign(**(fields | {"tube": {"inner_diameter": 0.4, "outer_diameter": 0.9, "wire_diameter": 0.05}}))


def test_a_tube_follows_from_spring_and_sheath() -> None:
    tube = Tube.model_validate(
        {"length": 12.5, "spring_outer_diameter": 0.6, "wire_diameter": 0.08, "sheath_wall": 0.15}
    )
    assert tube.inner_diameter == 0.44
    assert tube.outer_diameter == 0.9
    assert tube.spring_outer_diameter == pytest.approx(0.6)


# -- files ------------------------------------------------------------------------------------------
def test_a_file_that_cannot_be_read_is_named(tmp_path: Path) -> None:
    cases = {
        "missing.toml": (None, "no such file"),
        "folder.toml": ("folder", "is a folder, not a design file"),
        "latin.toml": ("name = 'caf\u00e9'".encode("latin-1"), "byte 11 is not UTF-8"),
        "syntax.toml": (b"name = \n", "is not TOML: Invalid value (at line 1"),
        "twice.toml": (b"name = 'a'\nname = 'b'\n", "is not TOML: Cannot overwrite a value (at line 2"),
        "cut.toml": (prototype_text("array-2x6").encode()[:900], "is missing"),
        "empty.toml": (b"", "name is missing: must be a text"),
        "large.toml": (b"#" * 1_000_001, "1000001 bytes must be at most 1000000"),
    }
    for name, (content, expected) in cases.items():
        path = tmp_path / name
        if content == "folder":
            path.mkdir()
        elif isinstance(content, bytes):
            path.write_bytes(content)
        with pytest.raises(DesignError) as caught:
            geometry.load_design(path)
        assert str(caught.value).startswith(f"{path}: ")
        assert expected in str(caught.value)
        assert "\n" not in str(caught.value)


def test_a_design_is_named_by_prototype_or_by_file(tmp_path: Path) -> None:
    design = geometry.prototype("glove")
    geometry.save_design(design, tmp_path / "mine.toml")
    assert geometry.resolve_design("glove") == design
    assert geometry.resolve_design(tmp_path / "mine.toml") == design
    with pytest.raises(DesignError, match=r"^glov: neither a design file nor a prototype; did you mean 'glove'\?"):
        geometry.resolve_design("glov")
    with pytest.raises(DesignError, match=r"^other\.toml: no such file"):
        geometry.resolve_design("other.toml")
    with pytest.raises(DesignError, match=r"^no prototype is named 'array'; did you mean 'array-2x6'\?"):
        geometry.prototype("array")


def test_saving_leaves_the_whole_file_or_the_old_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "design.toml"
    first = geometry.prototype("array-2x6")
    geometry.save_design(first, path)
    monkeypatch.setattr(
        "geometry.ground.whole_files.os.fsync", lambda _: (_ for _ in ()).throw(OSError(28, "No space left"))
    )
    with pytest.raises(DesignError, match="cannot be written: No space left"):
        geometry.save_design(first.with_values({"tube.length": 20.0}), path)
    monkeypatch.undo()
    assert geometry.load_design(path) == first
    assert [entry.name for entry in tmp_path.iterdir()] == ["design.toml"]


def test_saving_into_a_missing_folder_is_one_line(tmp_path: Path) -> None:
    with pytest.raises(DesignError, match=r"design\.toml: cannot be written: No such file"):
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
        "description": draw(st.text(st.characters(codec="utf-8", exclude_categories=("Cs",)), max_size=60)),
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


@pytest.mark.parametrize(
    ("name", "rest"),
    [
        ("tube.inner_diametre", "is not a field of this design; did you mean 'inner_diameter'?"),
        ("lines.7.points", "is not a field of this design; known: 0"),
        ("lines.x", "is not a field of this design; known: 0"),
        ("tube.length.x", "is not a field of this design"),
        ("tube.width", "is not a field of this design; known: wire_diameter, "),
        ("x", "is not a field of this design; known: "),
    ],
)
def test_a_change_of_an_unknown_field_is_refused_with_a_suggestion(name: str, rest: str) -> None:
    with pytest.raises(DesignError) as caught:
        geometry.prototype("array-2x6").with_values({name: 1.0})
    assert str(caught.value).startswith(f"array-2x6: {name} {rest}")


def test_a_field_of_a_table_that_is_not_given_asks_for_the_whole_table() -> None:
    with pytest.raises(DesignError, match=r"lines\.0\.tube is not given; give the whole table"):
        geometry.prototype("array-2x6").with_values({"lines.0.tube.length": 14.0})


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


@pytest.mark.parametrize(
    ("law", "message"),
    [
        ({}, r"loss_factor is missing; law = 'spring-pot' needs it"),
        ({"loss_factor": 0.1, "relaxation_times": [1.0]}, r"need law = 'prony', not 'spring-pot'"),
        ({"law": "prony"}, r"relaxation_times and relaxation_moduli must be given"),
        ({"law": "prony", "relaxation_times": [1.0], "relaxation_moduli": [1.0, 2.0]}, r"has 1 values, .* 2; as many"),
        (
            {"law": "prony", "relaxation_times": [1.0], "relaxation_moduli": [1.0], "loss_factor": 0.1},
            r"loss_factor = 0\.1 must not be given",
        ),
        ({"law": "prony", "relaxation_times": [-1.0], "relaxation_moduli": [1.0]}, r"relaxation_times"),
    ],
)
def test_the_law_of_a_material_is_complete_or_refused(law: dict[str, object], message: str) -> None:
    common = {"youngs_modulus": 1.0, "poisson_ratio": 0.49, "density": 1000.0, "source": "test"}
    with pytest.raises(DesignError, match=message) as refused:
        Material(**common, **law)
    assert "\n" not in str(refused.value)


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
    with pytest.raises(ValueError, match=r"fraction_of_first = 1\.5 must be between 0 and 1"):
        blend_modulus(1.0, 2.0, 1.5)
    with pytest.raises(ValueError, match="shore_a = 95 must be between 0 and 90"):
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
