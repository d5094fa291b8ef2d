"""3-D cells against the reference cell, exact ducts, limits and symmetries."""

import errno
import os

import cadquery as cq
import numpy as np
import pytest
from coarse_cells import coarse_cells
from reference_data import AIR, column
from refusals import refused

from acoustic_fem.cavity.closed_forms import closed_cylinder_compliance
from acoustic_fem.cell.design_cells import solve_cells
from acoustic_fem.cell.lumped import lumped_admittance
from acoustic_fem.cell.one_cell import CellError, CellFault, CellTask, solve_task
from acoustic_fem.cell.solid import port_admittance, solve_solid
from acoustic_fem.duct import plane_wave
from acoustic_fem.numerics import disk_cache
from acoustic_fem.numerics.linear_solver import LinearSolverError
from geometry.air.cells import Cell
from geometry.air.mesh import MeshError
from geometry.air.mirror_symmetry import mirror_half
from geometry.ground.refusal import Kind, Refusal
from geometry.schema.ports import CellPort

STRAIGHT = Cell("resonator", 6.0, 2.5, 1.25, (CellPort(0.0, 0.5), CellPort(180.0, 0.5)), 6.0, 0.0)
CHAMBER = Cell("microphone", 2.2, 1.3, 0.65, (CellPort(0.0, 0.44),), 0.5, 0.3)
FREQUENCY = column("resonator_cell", "frequency")


@pytest.fixture(scope="module")
def straight():
    return solve_cells([STRAIGHT], FREQUENCY, AIR)[STRAIGHT].admittance


def rigid_and_extended(nodal, extension):
    """Close the opening rigidly and put a duct on each of the two stubs."""
    inner = nodal[:, :2, :2] - nodal[:, :2, 2:] @ nodal[:, 2:, :2] / nodal[:, 2:, 2:]
    whole = np.zeros((len(nodal), 4, 4), dtype=complex)
    whole[:, :2, :2] = inner
    for k in range(2):
        whole[np.ix_(range(len(nodal)), [k, 2 + k], [k, 2 + k])] += extension
    return whole[:, 2:, 2:] - whole[:, 2:, :2] @ np.linalg.solve(whole[:, :2, :2], whole[:, :2, 2:])


def test_resonator_cell_matches_the_reference_within_two_parts_per_thousand(straight):
    extension = plane_wave.port_admittance(2.5e-4, 5.25e-3, FREQUENCY, AIR)
    admittance = rigid_and_extended(straight, extension)
    np.testing.assert_allclose(admittance[:, 0, 0], column("resonator_cell", "Y11"), rtol=1e-3)
    np.testing.assert_allclose(admittance[:, 0, 1], column("resonator_cell", "Y12"), rtol=1e-3)


@pytest.mark.slow
def test_the_same_cell_from_a_cad_solid_with_thermal_field_by_fem():
    solid = cq.Workplane().cylinder(2.5, 3).union(cq.Workplane("YZ").circle(0.25).extrude(9.25, both=True))
    admittance = port_admittance(solid, {"a": (9.25, 0, 0), "b": (-9.25, 0, 0)}, FREQUENCY, AIR)
    np.testing.assert_allclose(admittance[:, 0, 0], column("resonator_cell", "Y11"), rtol=1e-3)
    np.testing.assert_allclose(admittance[:, 0, 1], column("resonator_cell", "Y12"), rtol=1e-3)
    # The compliance is the small sum of the two.
    total = column("resonator_cell", "Y11") + column("resonator_cell", "Y12")
    np.testing.assert_allclose(admittance[:, 0].sum(axis=1), total, rtol=1e-3)


def _with_tubes(body, angles, height, reach=4.0):
    ports = {}
    for number, angle in enumerate(angles):
        direction = cq.Vector(np.cos(np.radians(angle)), np.sin(np.radians(angle)), 0)
        start, end = (cq.Vector(0, 0, height) + direction * radius for radius in (1.0, reach))
        body = body.fuse(cq.Solid.makeCylinder(0.25, (end - start).Length, start, direction))
        ports[f"{number}"] = end.toTuple()
    return body.clean(), ports


@pytest.mark.slow
@pytest.mark.parametrize(
    ("body", "angles", "reach"),
    [
        (cq.Solid.makeBox(5, 4, 2.5, cq.Vector(-2.5, -2, 0)), (0, 180), 4.0),
        (cq.Solid.makeCylinder(3, 2.5), (0, 90), 4.0),
        (cq.Solid.makeCylinder(2, 2), (0, 120, 240), 3.0),
    ],
    ids=["box", "right angle", "three ports"],
)
def test_accuracy_holds_against_finer_meshes_in_every_entry_and_in_the_sum(body, angles, reach):
    """The ports are off mid height, so that no mirror plane makes it easier than it is."""
    solid, ports = _with_tubes(body, angles, 1.1, reach)
    solved = solve_solid(solid, ports, (1.0, 100.0), AIR, accuracy=1e-3)
    admittance = solved.body.nodal_admittance(FREQUENCY)
    finer = solve_solid(solid, ports, (1.0, 100.0), AIR, accuracy=5e-4).body.nodal_admittance(FREQUENCY)
    np.testing.assert_allclose(admittance, finer, rtol=1e-3)
    np.testing.assert_allclose(admittance.sum(axis=(1, 2)), finer.sum(axis=(1, 2)), rtol=1e-3)
    assert solved.mesh_error < 1e-3
    assert {mesh.field for mesh in solved.convergence} == {"heat", "flow"}


def test_nodal_admittance_is_symmetric_and_passive(straight):
    np.testing.assert_allclose(straight, straight.transpose(0, 2, 1), rtol=1e-9)
    assert np.linalg.eigvalsh(straight.real).min() > 0


def test_mirror_symmetric_cell_has_equal_ports(straight):
    # The mesh is not mirrored: the difference is a part of the mesh error.
    np.testing.assert_allclose(straight[:, 0, 0], straight[:, 1, 1], rtol=2e-3)


def test_all_ports_at_one_pressure_see_the_compliance_of_the_air(straight):
    inflow = straight.sum(axis=(1, 2))
    omega = 2 * np.pi * FREQUENCY
    cavity = closed_cylinder_compliance(3e-3, 2.5e-3, FREQUENCY, AIR)
    stub = plane_wave.shunt_admittance(2.5e-4, FREQUENCY, AIR) * STRAIGHT.ports[0].stub_length * 1e-3
    # The closed forms keep the mouths of the tubes at wall temperature; the cell does not.
    np.testing.assert_allclose(inflow, 1j * omega * cavity + 2 * stub, rtol=2e-3)


@pytest.mark.slow
@pytest.mark.parametrize("cell", [STRAIGHT, CHAMBER], ids=["resonator", "microphone"])
def test_closed_forms_and_finite_elements_agree_on_a_cell(cell):
    fem = solve_cells([cell], FREQUENCY, AIR)[cell].admittance
    closed = lumped_admittance(cell, FREQUENCY, AIR)
    scale = np.abs(np.einsum("fii->fi", closed))
    difference = np.abs(fem - closed) / np.sqrt(scale[:, :, None] * scale[:, None, :])
    # The stub is a third of all resistance here; the entrance correction carries the difference.
    assert difference.max() < 0.03


TUBE = cq.Workplane("YZ").circle(0.25).extrude(3)
ENDS = {"a": (0, 0, 0), "b": (3, 0, 0)}


@pytest.fixture(scope="module")
def tube():
    """A straight tube, and its exact admittance at three frequencies."""
    frequency = np.array([1.0, 10.0, 100.0])
    solved = solve_solid(TUBE, ENDS, (1.0, 100.0), AIR, accuracy=2e-3)
    return solved, frequency, plane_wave.port_admittance(2.5e-4, 3e-3, frequency, AIR)


@pytest.mark.slow
def test_straight_tube_converges_to_the_exact_duct(tube):
    solved, frequency, exact = tube
    coarse = solved.body.nodal_admittance(frequency)
    fine = port_admittance(TUBE, ENDS, frequency, AIR, accuracy=5e-4)
    errors = [np.abs(admittance / exact - 1).max() for admittance in (coarse, fine)]
    assert errors[0] < 2e-3
    assert errors[1] < 5e-4
    assert errors[1] < errors[0]


@pytest.mark.slow
def test_half_a_symmetric_cell_answers_as_the_whole_one():
    """Turned by half a degree the same ports are off the mirror plane, and the whole cell is solved."""
    almost = Cell("resonator", 6.0, 2.5, 1.25, (CellPort(0.0, 0.5), CellPort(179.5, 0.5)), 6.0, 0.0)
    with coarse_cells():
        half, whole = (solve_cells([cell], [1.0, 100.0], AIR)[cell] for cell in (STRAIGHT, almost))
    assert half.unknowns < 0.8 * whole.unknowns
    scale = np.sqrt(np.abs(np.einsum("fii->fi", whole.admittance)))
    difference = np.abs(half.admittance - whole.admittance) / (scale[:, :, None] * scale[:, None, :])
    assert difference.max() < half.mesh_error + whole.mesh_error


@pytest.mark.slow
def test_half_a_body_of_any_shape_answers_as_the_whole_one():
    solid, ports = _with_tubes(cq.Solid.makeBox(5, 4, 3, cq.Vector(-2.5, -2, 0)), (0, 180), height=1.0)
    solid = solid.Solids()[0]
    # A groove too small to matter ends the symmetry.
    notch = cq.Solid.makeBox(0.3, 0.02, 0.02, cq.Vector(0.5, 1.99, 2.99))
    notched, accuracy = solid.cut(notch).Solids()[0], 0.02
    assert mirror_half(notched, ports) is None
    with coarse_cells():
        halved, whole = (solve_solid(each, ports, (1.0, 100.0), AIR, accuracy=accuracy) for each in (solid, notched))
    assert (halved.body.copies, whole.body.copies) == (2, 1)
    half, entire = (each.body.nodal_admittance(np.array([1.0, 100.0])) for each in (halved, whole))
    np.testing.assert_allclose(half, entire, rtol=2 * accuracy)
    np.testing.assert_allclose(half.sum(axis=(1, 2)), entire.sum(axis=(1, 2)), rtol=2 * accuracy)


@pytest.mark.slow
def test_what_flows_at_one_port_for_a_pressure_at_the_other_is_the_same_both_ways():
    """Before the response is averaged with its transpose: each column is a solution of its own."""
    bent = cq.Workplane("YZ").circle(0.25).extrude(2).union(cq.Workplane("XZ").circle(0.4).extrude(-2))
    with coarse_cells():
        body = solve_solid(bent, {"a": (2, 0, 0), "b": (0, 2, 0)}, (1.0, 100.0), AIR, accuracy=0.03).body
    size = len(body.flow.matrices)
    theta, phi = np.ones((1, size), dtype=complex), np.ones((1, len(body.flow.excitations)), dtype=complex)
    theta[0, 1:] *= 1e-2j
    theta[0, 2] = -1.0
    solution, excitation = body.flow.coordinates(theta, phi)
    response = np.einsum("frm,frn->fmn", excitation, solution)
    assert abs(response[0, 0, 1] / response[0, 0, 0]) > 0.01
    np.testing.assert_allclose(response[0, 0, 1], response[0, 1, 0], rtol=1e-9)


def test_mesh_error_reported_covers_the_error_in_a_straight_tube(tube):
    solved, frequency, exact = tube
    error = np.abs(solved.body.nodal_admittance(frequency) / exact - 1).max()
    assert error < 1.5 * solved.mesh_error
    with refused(Kind.OUT_OF_RANGE, "frequency", 200.0):
        solved.body.nodal_admittance(np.array([10.0, 200.0]))
    assert solved.mesh_error <= 2e-3


@pytest.mark.slow
def test_helmholtz_is_exact_in_a_straight_tube_and_five_percent_off_at_openings():
    exact = plane_wave.port_admittance(2.5e-4, 3e-3, FREQUENCY, AIR)
    straight_tube = port_admittance(TUBE, ENDS, FREQUENCY, AIR, "helmholtz", accuracy=3e-3)
    np.testing.assert_allclose(straight_tube, exact, rtol=3e-3)
    extension = plane_wave.port_admittance(2.5e-4, 5.25e-3, FREQUENCY, AIR)
    cell = rigid_and_extended(solve_cells([STRAIGHT], FREQUENCY, AIR, "helmholtz")[STRAIGHT].admittance, extension)
    error = np.abs(cell[0, 0, 0] / column("resonator_cell", "Y11")[0] - 1)
    assert 0.04 < error < 0.06


@pytest.mark.slow
@pytest.mark.parametrize("count", [1, 2], ids=["in this process", "in processes"])
def test_a_cell_that_cannot_be_drawn_is_named(count, monkeypatch, tmp_path):
    monkeypatch.setenv("ACOUSTIC_FEM_CACHE", str(tmp_path))
    monkeypatch.setattr("acoustic_fem.cell.design_cells.cores", lambda: 2)
    cells = [
        Cell("resonator", 3.0 + k, 2.0, 1.0, (CellPort(0.0, 0.6), CellPort(5.0, 0.6)), 3.0, 0.0) for k in range(count)
    ]
    with pytest.raises(CellError, match=r"resonator [34] x 2 mm .* overlapping ports"):
        solve_cells(cells, [10.0], AIR)


def test_only_what_the_kernel_or_the_memory_refuses_is_a_cell_without_solution(monkeypatch):
    from OCP.Standard import Standard_Failure

    task = CellTask(STRAIGHT, AIR, (1.0, 100.0), "navier-stokes")
    raised: list[Exception] = [Standard_Failure("no solid"), MemoryError(), Refusal("too thin", kind=Kind.OUT_OF_RANGE)]
    mistakes: list[Exception] = [ValueError("shapes differ"), RuntimeError("broken"), ZeroDivisionError(), KeyError()]
    for error in (*raised, *mistakes):

        def fails(*_: object, error: Exception = error, **__: object) -> None:
            raise error

        monkeypatch.setattr("acoustic_fem.cell.one_cell.air_volume", fails)
        with pytest.raises(CellError if error in raised else type(error)):
            solve_task(task, lambda fraction: None)


@pytest.mark.slow
def test_box_with_corners_keeps_its_whole_isothermal_compliance():
    box = cq.Workplane().box(4, 3, 2).union(cq.Workplane("YZ").circle(0.25).extrude(3))
    admittance = port_admittance(box, {"mouth": (3, 0, 0)}, [0.01, 0.1], AIR)[:, 0, 0]
    compliance = admittance / (2j * np.pi * np.array([0.01, 0.1]))
    np.testing.assert_allclose(compliance.real, box.val().Volume() * 1e-9 / AIR.pressure, rtol=1e-4)


@pytest.mark.slow
def test_cells_are_reused_from_the_cache_and_damaged_files_made_again(tmp_path, monkeypatch):
    monkeypatch.setenv("ACOUSTIC_FEM_CACHE", str(tmp_path))
    labels = []

    def solve(*frequency):
        with coarse_cells():
            return solve_cells([CHAMBER], frequency, AIR, progress=lambda label, done: labels.append(label))[CHAMBER]

    first = solve(10.0)
    labels.clear()
    again = solve(10.0, 20.0)
    assert not first.cached
    assert again.cached
    assert labels
    assert all(label.endswith("(from the cache)") for label in labels)
    np.testing.assert_array_equal(again.admittance[0], first.admittance[0])

    (file,) = disk_cache.cache_folder().glob("*.cell")
    content = bytearray(file.read_bytes())
    content[len(content) // 2] ^= 1
    file.write_bytes(content)
    with pytest.warns(UserWarning, match=r"is damaged: .*; the cell is solved again"):
        restored = solve(10.0)
    assert not restored.cached
    np.testing.assert_allclose(restored.admittance, first.admittance, rtol=1e-9)


@pytest.mark.parametrize("place", ["a-file", "below-a-file/cells", "read-only/cells"])
def test_a_cache_folder_that_cannot_be_written_is_said_and_loses_nothing(tmp_path, monkeypatch, place):
    (tmp_path / "a-file").write_text("not a folder")
    (tmp_path / "below-a-file").write_text("not a folder")
    monkeypatch.setenv("ACOUSTIC_FEM_CACHE", str(tmp_path / place))
    if place.startswith("read-only"):  # the file system's own word: permissions do not bind every user
        monkeypatch.setattr("pathlib.Path.mkdir", read_only)
    expected = r"cannot be written \((File exists|Not a directory|Read-only file system)\); what was solved is not kept"
    with pytest.warns(UserWarning, match=expected) as said:
        disk_cache.store("key", {"matrices": np.eye(2)}, {})
    assert len(said) == 1
    assert str(said[0].message).startswith(f"{tmp_path / place}: ")
    assert "ACOUSTIC_FEM_CACHE" in str(said[0].message)
    assert disk_cache.fetch("key") is None


def read_only(*_, **__):
    raise OSError(errno.EROFS, os.strerror(errno.EROFS))


@pytest.mark.slow
def test_a_full_disk_keeps_the_result_and_leaves_no_half_file(tmp_path, monkeypatch):
    monkeypatch.setenv("ACOUSTIC_FEM_CACHE", str(tmp_path))

    def full(file):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr("os.fsync", full)
    expected = r"cannot be written \(No space left on device\); what was solved is not kept"
    with pytest.warns(UserWarning, match=expected), coarse_cells():
        solution = solve_cells([CHAMBER], [10.0], AIR)[CHAMBER]
    assert np.isfinite(solution.admittance).all()
    assert not solution.cached
    assert list(tmp_path.iterdir()) == []


def test_a_cell_that_cannot_be_read_is_said_and_solved_again(tmp_path, monkeypatch):
    monkeypatch.setenv("ACOUSTIC_FEM_CACHE", str(tmp_path))
    (tmp_path / "key.cell").mkdir()
    with pytest.warns(UserWarning, match=r"key\.cell: is a folder, not a record.*; the cell is solved again"):
        assert disk_cache.fetch("key") is None


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"frequency": [10.0, 5.0]}, "frequency must ascend"),
        ({"accuracy": 0.5}, "accuracy = 0.5"),
        ({"fidelity": "guess"}, "fidelity = 'guess'"),
        ({"ports": {"a": (0, 0, 9)}}, r"faces\.a = .* lies on 0 faces"),
        ({"solid": "missing.step"}, "missing.step: no such file"),
    ],
    ids=lambda value: "" if isinstance(value, str) else next(iter(value)),
)
def test_bad_input_is_refused_by_name(change, message):
    good = {"solid": cq.Solid.makeBox(1, 1, 1), "ports": {"a": (0.5, 0.5, 0)}, "frequency": [1.0], "air": AIR}
    with pytest.raises((ValueError, MeshError, LinearSolverError), match=message):
        port_admittance(**{**good, **change})


@pytest.mark.slow
def test_a_mistake_in_a_process_that_solves_a_cell_is_not_taken_for_a_cell_without_solution(
    tmp_path, monkeypatch, capfd
):
    (tmp_path / "sitecustomize.py").write_text(
        "import geometry.air.volume\ngeometry.air.volume.air_volume = lambda cell, **_: cell.nonsense\n"
    )
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setenv("ACOUSTIC_FEM_CACHE", str(tmp_path / "cache"))
    cell = Cell("resonator", 3.0, 2.0, 1.0, (CellPort(0.0, 0.4),), 3.0, 0.0)
    with pytest.raises(CellFault, match=r"AttributeError: 'Cell' object has no attribute 'nonsense'"):
        solve_cells([cell], [10.0], AIR, "helmholtz", apart=True)
    assert "Traceback" in capfd.readouterr().err
