"""Cells and bodies of air from bad input: one clear error before any work, or the right numbers all the same."""

import io
from functools import partial
from pathlib import Path

import cadquery as cq
import numpy as np
import pytest
from OCP.BRepPrimAPI import BRepPrimAPI_MakeHalfSpace
from OCP.gp import gp_Pnt
from reference_data import AIR
from refusals import check_messages, refused

import acoustic_fem
from acoustic_fem.batch.parameters import ArrayParameters
from acoustic_fem.cavity import closed_forms
from acoustic_fem.cell import solid
from acoustic_fem.cell.bent_bore import solve_bent_bores
from acoustic_fem.cell.design_cells import solve_cells
from acoustic_fem.cell.one_cell import CellError
from acoustic_fem.duct import plane_wave, tube_opening
from acoustic_fem.library.noise_floor import detection_limits
from acoustic_fem.membrane.disc import DiscOptions, solve_disc
from acoustic_fem.numerics import disk_cache
from acoustic_fem.numerics.disk_cache import CacheWarning
from acoustic_fem.quantities import checks
from acoustic_fem.quantities.medium import Medium
from geometry.air.cells import Cell
from geometry.air.wound_tube import Winding
from geometry.design.design_file import prototype
from geometry.ground.argument_checks import check_range, real_numbers
from geometry.ground.refusal import Kind
from geometry.schema.ports import CellPort

CHAMBER = Cell("microphone", 2.2, 1.3, 0.65, (CellPort(0.0, 0.44),), 0.5, 0.3)
DESIGN = prototype("array-2x6")
BOX = cq.Solid.makeBox(1, 1, 1)


@pytest.fixture
def no_meshing(monkeypatch):
    """Bad input must be found before any work."""

    def refuse(*_, **__):
        raise AssertionError("work has begun")

    monkeypatch.setattr("geometry.air.mesh._run_gmsh", refuse)
    monkeypatch.setattr("acoustic_fem.library.network_responses.place_housings", refuse)


# -- frequencies ------------------------------------------------------------------------------------------
GRIDS = {
    "zero": ([0.0, 1.0], Kind.OUT_OF_RANGE),
    "negative": ([-1.0, 1.0], Kind.OUT_OF_RANGE),
    "too high": ([1.0, 3000.0], Kind.OUT_OF_RANGE),
    "unsorted": ([2.0, 1.0], Kind.OUT_OF_RANGE),
    "twice": ([1.0, 1.0], Kind.OUT_OF_RANGE),
    "not a number": ([1.0, np.nan], Kind.OUT_OF_RANGE),
    "infinite": ([1.0, np.inf], Kind.OUT_OF_RANGE),
    "empty": ([], Kind.WRONG_TYPE),
    "a table": ([[1.0, 2.0]], Kind.WRONG_TYPE),
    "complex": ([1 + 1j], Kind.WRONG_TYPE),
    "a list of texts": (["ten"], Kind.WRONG_TYPE),
    "ragged": ([[1.0], [1.0, 2.0]], Kind.WRONG_TYPE),
    "a text of two": ("1:100", Kind.WRONG_TYPE),
    "a text without numbers": ("a:b:c", Kind.WRONG_TYPE),
    "a text of no frequency": ("1:100:0", Kind.OUT_OF_RANGE),
}


@pytest.mark.parametrize("name", GRIDS)
@pytest.mark.parametrize(
    "entry",
    [
        lambda grid: solid.port_admittance(BOX, {"a": (0.5, 0.5, 0.0)}, grid, AIR),
        lambda grid: acoustic_fem.solve(DESIGN, grid, "lumped"),
        lambda grid: acoustic_fem.solve(DESIGN, grid),
        lambda grid: solve_cells([CHAMBER], grid, AIR),
    ],
    ids=["cell", "solve lumped", "solve", "solve_cells"],
)
@pytest.mark.usefixtures("no_meshing")
def test_a_bad_grid_of_frequencies_is_refused_by_name_before_any_work(entry, name):
    grid, kind = GRIDS[name]
    with refused(kind, "frequency"):
        entry(grid)


@pytest.mark.parametrize("frequency", [0.0, -1.0, np.nan, np.inf, 1j, "ten", None])
@pytest.mark.parametrize(
    "entry",
    [
        lambda f: plane_wave.port_admittance(1e-4, 0.01, f, AIR),
        lambda f: plane_wave.series_impedance(1e-4, f, AIR),
        lambda f: closed_forms.closed_cylinder_compliance(1e-3, 1e-3, f, AIR),
        lambda f: closed_forms.closed_sphere_compliance(1e-3, f, AIR),
        lambda f: tube_opening.entrance_impedance(1e-4, f, AIR),
    ],
    ids=["duct", "series", "cylinder", "sphere", "opening"],
)
def test_a_closed_form_refuses_a_frequency_without_meaning_by_name(entry, frequency):
    is_number = isinstance(frequency, float)
    with refused(Kind.OUT_OF_RANGE if is_number else Kind.WRONG_TYPE, "frequency"):
        entry(frequency)


def test_a_grid_may_be_a_text_of_first_last_and_count():
    np.testing.assert_array_equal(checks.frequency_grid("1:500:500"), np.arange(1.0, 501.0))


def test_closed_forms_take_frequencies_in_any_order():
    falling, rising = np.array([20.0, 1.0]), np.array([1.0, 20.0])
    np.testing.assert_array_equal(
        plane_wave.port_admittance(1e-4, 0.01, falling, AIR), plane_wave.port_admittance(1e-4, 0.01, rising, AIR)[::-1]
    )


def test_just_above_frequency_zero_a_duct_is_poiseuille_flow_and_a_sealed_array_has_one_pressure():
    resistance = 8 * AIR.viscosity * 0.01 / (np.pi * 1e-16)
    static = np.array([[1, -1], [-1, 1]]) / resistance
    np.testing.assert_allclose(plane_wave.port_admittance(1e-4, 0.01, 1e-6, AIR), static, rtol=1e-6)
    one = acoustic_fem.solve(DESIGN, [1e-3], "lumped").transfer_function.values
    np.testing.assert_allclose(one, 1, atol=3e-3)


def comb(teeth):
    """A body with four faces for each tooth."""
    outline = [(x, y) for k in range(teeth) for x, y in ((k, 0), (k, 1), (k + 0.5, 1), (k + 0.5, 0))]
    return cq.Workplane().polyline([*outline, (teeth, 0), (teeth, -1), (0, -1)]).close().extrude(1).val()


def half_space():
    """A solid that has no end."""
    plane = cq.Face.makePlane(1, 1).wrapped
    return cq.Solid(BRepPrimAPI_MakeHalfSpace(plane, gp_Pnt(0, 0, 1)).Solid())


# -- ports and solids -------------------------------------------------------------------------------------
BODIES = {
    "no port": {"ports": {}},
    "too many ports": {"ports": {str(k): (0, 0, k) for k in range(51)}},
    "a list": {"ports": [("a", (0, 0, 0))]},
    "none": {"ports": None},
    "two numbers": {"ports": {"a": (0.5, 0.5)}},
    "not finite": {"ports": {"a": (0.5, 0.5, np.nan)}},
    "a text": {"ports": {"a": "here"}},
    "the wall": {"ports": {"wall": (0.5, 0.5, 0)}},
    "a number": {"ports": {3: (0.5, 0.5, 0)}},
    "nowhere": {"ports": {"a": (9, 9, 9)}},
    "an edge": {"ports": {"a": (0, 0, 0.5)}},
    "a corner": {"ports": {"a": (0, 0, 0)}},
    "one face twice": {"ports": {"a": (0.5, 0.5, 0), "b": (0.4, 0.5, 0)}},
    "round": {"solid": cq.Solid.makeCylinder(1, 1), "ports": {"a": (-1, 0, 0.5)}},
    "spherical": {"solid": cq.Solid.makeSphere(1, angleDegrees1=0), "ports": {"a": (np.sqrt(0.5), 0.5, 0.5)}},
    "no solid": {"solid": None},
    "nothing drawn": {"solid": cq.Workplane()},
    "a face": {"solid": BOX.Faces()[0]},
    "two solids": {"solid": cq.Compound.makeCompound([BOX, BOX.moved(x=5)])},
    "a mile": {"solid": cq.Solid.makeBox(1e6, 1e6, 1e6)},
    "a sliver": {"solid": cq.Solid.makeBox(9, 9, 1e-5)},
    "a needle": {"solid": cq.Solid.makeBox(900, 0.02, 0.02), "ports": {"a": (0, 0.01, 0.01)}},
    "a tiny hole": {"solid": cq.Solid.makeBox(9, 9, 9).cut(cq.Solid.makeCylinder(2e-3, 9, cq.Vector(5, 5, 0)))},
    "a pinprick": {"solid": cq.Solid.makeBox(9, 9, 9).cut(cq.Solid.makeCylinder(1e-4, 9, cq.Vector(5, 5, 0)))},
    "a step": {"solid": BOX.fuse(cq.Solid.makeBox(1, 1, 5e-4, cq.Vector(1, 0, 0)))},
    "a comb": {"solid": comb(170)},
    "nothing in it": {"solid": cq.Compound.makeCompound([])},
    "no end": {"solid": half_space()},
    "not a number": {"solid": BOX.moved(x=np.nan)},
    "inside out": {"solid": cq.Shape.cast(BOX.wrapped.Reversed())},
    "accuracy": {"accuracy": np.nan},
    "accuracy in words": {"accuracy": "fine"},
    "fidelity": {"fidelity": "lumped"},
    "no gas": {"air": "thin"},
}


@pytest.mark.usefixtures("no_meshing")
def test_a_bad_body_of_air_is_refused_by_name_before_any_work():
    good = {"solid": BOX, "ports": {"a": (0.5, 0.5, 0)}, "frequency": [1.0], "air": AIR}
    cases = {name: partial(solid.port_admittance, **{**good, **change}) for name, change in BODIES.items()}
    check_messages(Path(__file__).with_name("bodies.txt"), cases)


@pytest.mark.parametrize("length", [0, 10, 100, 1000])
@pytest.mark.slow
def test_a_step_file_cut_short_is_refused_by_its_name(tmp_path, length):
    whole, cut = tmp_path / "whole.step", tmp_path / "cut.step"
    cq.exporters.export(cq.Workplane(BOX), str(whole))
    cut.write_bytes(whole.read_bytes()[:length])
    with pytest.raises(
        ValueError, match=r"cut\.step: cut short, damaged or not a STEP file|solid must be one CadQuery shape"
    ):
        solid.port_admittance(cut, {"a": (0.5, 0.5, 0)}, [1.0], AIR)


@pytest.mark.usefixtures("no_meshing")
def test_a_cavity_with_no_port_is_refused_by_its_name():
    sealed = Cell("resonator", 3.0, 2.0, 1.0, (), 3.0, 0.0)
    with pytest.raises(CellError, match=r"resonator 3 x 2 mm"):
        solve_cells([sealed], [1.0], AIR)


# -- checks -----------------------------------------------------------------------------------------------
def test_numbers_of_any_real_kind_are_taken():
    for values in (3, 3.0, np.float32(3), [3, 4.0], np.arange(3), range(3)):
        np.testing.assert_array_equal(real_numbers("x", values), np.asarray(values, dtype=float))
    with refused(Kind.WRONG_TYPE, "accuracy", [1e-3, 2e-3]):
        check_range("accuracy", [1e-3, 2e-3], 0, 1)


def test_messages_of_quantities_and_grids_read_well():
    helium = Medium(0.166, 1.96e-5, 0.152, 5193.0, 1.66, 101325.0)
    library = acoustic_fem.solve(DESIGN, [1.0], "lumped", helium)
    check_messages(
        Path(__file__).parent / "messages.txt",
        {
            **{f"grid, {name}": partial(checks.frequency_grid, grid) for name, (grid, _) in GRIDS.items()},
            "one number": lambda: check_range("accuracy", [1e-3, 2e-3], 0, 1),
            "range": lambda: check_range("accuracy", 0.5, 2e-4, 3e-3),
            "range with unit": lambda: Medium.at(pressure=1013.25),
            "positive": lambda: plane_wave.port_admittance(1e-4, -0.01, [1.0], AIR),
            "complex": lambda: plane_wave.UserLine(-1.0, 1e8).series_impedance(10.0, AIR),
            "choice": lambda: acoustic_fem.solve(DESIGN, [1.0], "exact"),
            "choice of a cell": lambda: solid.checked_physics("lumped"),
            "pressure and altitude": lambda: acoustic_fem.LocalAir(pressure=9e4, altitude=1000.0),
            "air twice": lambda: library.in_air(acoustic_fem.LocalAir(altitude=0.0), humidity=0.1),
            "a gas of its own": lambda: library.in_air(pressure=9e4),
            "no port": lambda: checks.port_points({}),
            "a point": lambda: checks.port_points({"a": (0.5, 0.5, np.nan)}),
            "the wall": lambda: checks.port_points({"wall": (0.5, 0.5, 0)}),
            "shape": lambda: acoustic_fem.solve(DESIGN.with_values({"resonator.shape": "dome"}), [1.0], "atlas"),
            "outside": lambda: acoustic_fem.solve(DESIGN.with_values({"resonator.cavity_height": 7.0}), [1.0], "atlas"),
            "no air": lambda: acoustic_fem.solve(DESIGN, [1.0], "atlas", helium),
            "batch": lambda: ArrayParameters.from_design(DESIGN.with_values({"resonator.shape": "dome"})),
            "stretch": lambda: ArrayParameters.from_design(DESIGN.with_values({"membrane.stretch": 1.2})),
            "disc": lambda: solve_disc(3e-3, 0.3e-3, 5e5, options=DiscOptions(stretch=1.1, tension=1.0)),
            "rim": lambda: solve_disc(3e-3, 0.3e-3, 5e5, options=DiscOptions(glue_width=1e-3)),
            "bend": lambda: solve_bent_bores(2.5e-4, [Winding(11.6, 90.0)], [1.0, 1900.0], AIR),
            "touch": lambda: library.touch_response("tickle"),
            "band": lambda: detection_limits(library, (50, 20)),
        },
    )


# -- the cache --------------------------------------------------------------------------------------------
@pytest.fixture
def kept(tmp_path, monkeypatch):
    """A stored record and the file that holds it."""
    monkeypatch.setenv("ACOUSTIC_FEM_CACHE", str(tmp_path))
    arrays = {"energies": np.arange(6.0).reshape(2, 3)}
    key = disk_cache.key_of({"cell": 1})
    disk_cache.store(key, arrays, {"unknowns": 7})
    return key, arrays, tmp_path / f"{key}.cell"


def test_a_kept_cell_comes_back_number_for_number(kept):
    key, arrays, _ = kept
    found, about = disk_cache.fetch(key)
    np.testing.assert_array_equal(found["energies"], arrays["energies"])
    assert about == {"unknowns": 7}


def test_a_cache_file_cut_short_anywhere_or_made_longer_is_said_and_not_used(kept):
    key, _, file = kept
    whole = file.read_bytes()
    for length in sorted({0, 1, 5, 19, 20, 21, 50, 84, 85, 86, *range(100, len(whole), 97), len(whole) - 1}):
        file.write_bytes(whole[:length])
        with pytest.warns(CacheWarning, match=r"is damaged: .*; the cell is solved again"):
            assert disk_cache.fetch(key) is None
    file.write_bytes(whole + b"\0")
    with pytest.warns(CacheWarning, match="is damaged"):
        assert disk_cache.fetch(key) is None
    file.write_bytes(whole)
    assert disk_cache.fetch(key) is not None


@pytest.mark.parametrize("content", [b"hello", b"PK\x03\x04", b"CDF\x01", bytes(1000)], ids=repr)
def test_a_foreign_file_in_the_cache_is_said_and_not_used(kept, content):
    key, _, file = kept
    if content == b"PK\x03\x04":  # a whole archive with the right names, but no checksum
        archive = io.BytesIO()
        np.savez(archive, energies=np.zeros((2, 3)), about=np.array("{}"))
        content = archive.getvalue()
    file.write_bytes(content)
    with pytest.warns(CacheWarning, match="is damaged"):
        assert disk_cache.fetch(key) is None


def test_the_file_of_another_cell_under_this_ones_name_is_said_and_not_used(kept):
    key, _, file = kept
    other = disk_cache.key_of({"cell": 2})
    file.rename(file.with_name(f"{other}.cell"))
    assert disk_cache.fetch(key) is None  # gone, which is no damage
    with pytest.warns(CacheWarning, match="is damaged"):
        assert disk_cache.fetch(other) is None
