"""Cells and bodies of air from bad input: one clear error before any work, or the right numbers all the same."""

import io

import cadquery as cq
import numpy as np
import pytest
from OCP.BRepPrimAPI import BRepPrimAPI_MakeHalfSpace
from OCP.gp import gp_Pnt
from reference_data import AIR

import acoustic_fem
from acoustic_fem.cavity import closed_forms
from acoustic_fem.cell import solid
from acoustic_fem.cell.design_cells import solve_cells
from acoustic_fem.duct import plane_wave, tube_opening
from acoustic_fem.numerics import disk_cache
from acoustic_fem.numerics.disk_cache import CacheWarning
from acoustic_fem.quantities import checks
from geometry.air.cells import Cell
from geometry.design.design_file import prototype
from geometry.ground.refusal import Refusal
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
    "zero": ([0.0, 1.0], "frequency = 0 Hz must be between 0.001 and 2000 Hz"),
    "negative": ([-1.0, 1.0], "frequency = -1 Hz must be between"),
    "unsorted": ([2.0, 1.0], "frequency must ascend: 1 Hz follows 2 Hz"),
    "twice": ([1.0, 1.0], "frequency must ascend: 1 Hz follows 1 Hz"),
    "not a number": ([1.0, np.nan], "frequency = nan Hz must be between"),
    "infinite": ([1.0, np.inf], "frequency = inf Hz must be between"),
    "empty": ([], "frequency has shape (0,)"),
    "a table": ([[1.0, 2.0]], "frequency has shape (1, 2)"),
    "complex": ([1 + 1j], "frequency must be a real number or an array of them; it is complex"),
    "text": (["ten"], "frequency must be a real number or an array of them; it is text: ['ten']"),
    "ragged": ([[1.0], [1.0, 2.0]], "frequency must be a real number or an array of them; its rows"),
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
    grid, message = GRIDS[name]
    with pytest.raises(ValueError) as error:
        entry(grid)
    assert message in str(error.value)


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
    with pytest.raises(ValueError, match=r"^frequency (= .* Hz must be finite and above 0 Hz|must be a real number)"):
        entry(frequency)


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
    "no port": ({"ports": {}}, "ports has 0 ports; it must have 1 to 50"),
    "too many ports": ({"ports": {str(k): (0, 0, k) for k in range(51)}}, "ports has 51 ports; it must have 1 to 50"),
    "a list": ({"ports": [("a", (0, 0, 0))]}, "ports must map names to points, not be a list"),
    "none": ({"ports": None}, "ports must map names to points, not be a NoneType"),
    "two numbers": ({"ports": {"a": (0.5, 0.5)}}, "port 'a' = (0.5, 0.5) must be a point of three finite numbers"),
    "not finite": ({"ports": {"a": (0.5, 0.5, np.nan)}}, "port 'a' = (0.5, 0.5, nan) must be a point of three"),
    "a text": ({"ports": {"a": "here"}}, "port 'a' must be a real number or an array of them; it is text"),
    "the wall": ({"ports": {"wall": (0.5, 0.5, 0)}}, "ports has the name 'wall'"),
    "a number": ({"ports": {3: (0.5, 0.5, 0)}}, "ports has the name 3; it must be a text"),
    "nowhere": ({"ports": {"a": (9, 9, 9)}}, "port 'a': the point (9.0, 9.0, 9.0) mm lies on 0 faces"),
    "an edge": ({"ports": {"a": (0, 0, 0.5)}}, "port 'a': the point (0.0, 0.0, 0.5) mm lies on 2 faces"),
    "a corner": ({"ports": {"a": (0, 0, 0)}}, "lies on 3 faces"),
    "one face twice": ({"ports": {"a": (0.5, 0.5, 0), "b": (0.4, 0.5, 0)}}, "['a', 'b'] lie on the same face"),
    "round": (
        {"solid": cq.Solid.makeCylinder(1, 1), "ports": {"a": (-1, 0, 0.5)}},
        "port 'a': the face at (-1.0, 0.0, 0.5) mm is CYLINDER, it must be flat",
    ),
    "spherical": (
        {"solid": cq.Solid.makeSphere(1, angleDegrees1=0), "ports": {"a": (np.sqrt(0.5), 0.5, 0.5)}},
        "is SPHERE, it must be flat",
    ),
    "no solid": ({"solid": None}, "solid must be one CadQuery shape, it holds NoneType"),
    "nothing drawn": ({"solid": cq.Workplane()}, "solid must be one CadQuery shape, it holds nothing"),
    "a face": ({"solid": BOX.Faces()[0]}, "the shape has 0 solids, it must be one"),
    "two solids": (
        {"solid": cq.Compound.makeCompound([BOX, BOX.moved(x=5)])},
        "the shape has 2 solids, it must be one",
    ),
    "a mile": ({"solid": cq.Solid.makeBox(1e6, 1e6, 1e6)}, "the solid is 1e+06 mm long; it must be at most 1000 mm"),
    "a sliver": ({"solid": cq.Solid.makeBox(9, 9, 1e-5)}, "mm across; it must be at least 0.01 mm"),
    "a needle": (
        {"solid": cq.Solid.makeBox(900, 0.02, 0.02), "ports": {"a": (0, 0.01, 0.01)}},
        "elements; it must be at most 1e+05: leave out small holes",
    ),
    "a tiny hole": (
        {"solid": cq.Solid.makeBox(9, 9, 9).cut(cq.Solid.makeCylinder(2e-3, 9, cq.Vector(5, 5, 0)))},
        "elements; it must be at most 1e+05: leave out small holes",
    ),
    "a pinprick": (
        {"solid": cq.Solid.makeBox(9, 9, 9).cut(cq.Solid.makeCylinder(1e-4, 9, cq.Vector(5, 5, 0)))},
        "has an edge 0.000628 mm long; it must be at least 0.001 mm",
    ),
    "a step": ({"solid": BOX.fuse(cq.Solid.makeBox(1, 1, 5e-4, cq.Vector(1, 0, 0)))}, "has an edge 0.0005 mm long"),
    "a comb": ({"solid": comb(170)}, "the solid has 684 faces; it must have at most 500"),
    "nothing in it": ({"solid": cq.Compound.makeCompound([])}, "the shape has 0 solids, it must be one"),
    "no end": ({"solid": half_space()}, "the solid has no end: its faces do not close"),
    "not a number": ({"solid": BOX.moved(x=np.nan)}, "the solid is nan mm long"),
    "inside out": ({"solid": cq.Shape.cast(BOX.wrapped.Reversed())}, "has a volume of -1 mm^3; it must be above 0"),
    "accuracy": ({"accuracy": np.nan}, "accuracy = nan must be between 0.0002 and 0.003"),
    "accuracy in words": ({"accuracy": "fine"}, "accuracy must be a real number or an array of them; it is text"),
    "fidelity": ({"fidelity": "lumped"}, "fidelity = 'lumped' must be one of navier-stokes, helmholtz"),
    "no gas": ({"medium": None}, "medium must be a Medium, not a NoneType"),
}


@pytest.mark.parametrize("name", BODIES)
@pytest.mark.usefixtures("no_meshing")
def test_a_bad_body_of_air_is_refused_by_name_before_any_work(name):
    change, message = BODIES[name]
    good = {"solid": BOX, "ports": {"a": (0.5, 0.5, 0)}, "frequency": [1.0], "medium": AIR}
    with pytest.raises(ValueError) as error:
        solid.port_admittance(**{**good, **change})
    assert message in str(error.value)


@pytest.mark.parametrize("length", [0, 10, 100, 1000])
def test_a_step_file_cut_short_is_refused_by_its_name(tmp_path, length):
    whole, cut = tmp_path / "whole.step", tmp_path / "cut.step"
    cq.exporters.export(cq.Workplane(BOX), str(whole))
    cut.write_bytes(whole.read_bytes()[:length])
    with pytest.raises(ValueError, match=r"cut\.step: cut short or not a STEP file|solid must be one CadQuery shape"):
        solid.port_admittance(cut, {"a": (0.5, 0.5, 0)}, [1.0], AIR)


@pytest.mark.usefixtures("no_meshing")
def test_a_cavity_with_no_port_is_refused_by_its_name():
    sealed = Cell("resonator", 3.0, 2.0, 1.0, (), 3.0, 0.0)
    with pytest.raises(Refusal, match=r"resonator 3 x 2 mm .* has no port; it needs at least one tube"):
        solve_cells([sealed], [1.0], AIR)


# -- checks -----------------------------------------------------------------------------------------------
def test_numbers_of_any_real_kind_are_taken():
    for values in (3, 3.0, np.float32(3), [3, 4.0], np.arange(3), range(3)):
        np.testing.assert_array_equal(checks.numbers("x", values), np.asarray(values, dtype=float))
    with pytest.raises(ValueError, match=r"^accuracy = \[0.001, 0.002\] must be one number$"):
        checks.in_range("accuracy", [1e-3, 2e-3], 0, 1)


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
