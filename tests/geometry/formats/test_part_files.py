"""Part files: closed bodies of the right volume, with units, names and parameters."""

import re

import cadquery as cq
import lib3mf
import manifold3d
import numpy as np
import pytest
import trimesh
from built import built
from refusals import refused

import geometry
import geometry.assembly.part_list
from geometry import Kind
from geometry.design.design_file import read_design
from geometry.formats import part_files
from geometry.formats.part_files import LARGEST_VOLUME_ERROR, export, tessellation_tolerance
from geometry.formats.three_mf import read_3mf
from geometry.printing.plates import export_plates
from geometry.printing.pose import MARGIN
from geometry.schema.print_processes import PROCESSES, with_rules
from geometry.solids.measure import tessellate


@pytest.fixture(
    scope="module",
    params=[
        "array-2x6",
        *(pytest.param(name, marks=pytest.mark.slow) for name in ("fingertip-3x4", "glove", "large-area-64")),
    ],
)
def design(request):
    found = geometry.prototype(request.param)
    # a mold of one cavity is drawn quickly; the slow ones have many
    return found.with_values({"mold.rows": 1, "mold.columns": 1}) if request.param == "array-2x6" else found


@pytest.fixture(scope="module")
def exported(design, tmp_path_factory):
    parts = geometry.build_parts(design)
    folder = tmp_path_factory.mktemp("parts")
    return parts, folder, export(parts, folder)


def box(**sizes):
    return {name: cq.Workplane(cq.Solid.makeBox(*size)) for name, size in sizes.items()}


def test_files_are_named_after_parts_and_formats(exported):
    parts, folder, files = exported
    expected = [f"{name}.{format_}" for name in parts for format_ in ("stl", "step", "3mf")]
    assert [file.path.name for file in files] == expected
    assert sorted(path.name for path in folder.iterdir()) == sorted(expected)


def test_every_stl_is_one_closed_body_of_the_cad_volume(design, exported):
    parts, _, files = exported
    mold = geometry.molds.plan_mold(design)
    # Ways through: ejector holes of a base, sockets and vents of a lid, a ring, holes of a board; others: one per port.
    ways = {
        **{"mold-base": len(mold.ejector_spots), "mold-lid": 3 + 2 * mold.rows * mold.columns, "mold-shim": 1},
        **{"membrane": 0, "mold-plugs": 0, "microphone-board": 5},
    }
    checked = 0
    for file in files:
        if file.format != "stl":
            continue
        mesh = trimesh.load_mesh(file.path)
        assert mesh.is_volume
        assert mesh.body_count == 1
        assert mesh.volume == pytest.approx(parts[file.part].val().Volume(), rel=1e-3)
        assert len(mesh.faces) == file.triangles
        if "ports" in parts.parameters[file.part]:
            through = parts.parameters[file.part]["ports"].count("bore")
            assert through >= 1
        else:
            through = next(count for start, count in ways.items() if file.part.startswith(start))
        assert mesh.euler_number == 2 - 2 * through
        manifold = manifold3d.Manifold(
            manifold3d.Mesh64(np.asarray(mesh.vertices), np.asarray(mesh.faces, dtype=np.uint64))
        )
        assert manifold.status() == manifold3d.Error.NoError
        assert manifold.volume() == pytest.approx(parts[file.part].val().Volume(), rel=1e-3)
        checked += 1
    assert checked == len(parts)


def test_records_tell_deviation_and_volume_error(exported):
    parts, _, files = exported
    tolerance = tessellation_tolerance(parts)
    for file in files:
        assert abs(file.volume_error) < (1e-9 if file.format == "step" else 1e-3)
        if file.format == "step":
            assert file.triangles is None
            assert file.linear_deviation is None
        else:
            assert file.triangles > 10
            assert 0 < file.linear_deviation <= tolerance


def test_3mf_carries_unit_name_and_generating_parameters(exported):
    parts, folder, _ = exported
    name = next(iter(parts))
    model = lib3mf.get_wrapper().CreateModel()
    model.QueryReader("3mf").ReadFromFile(str(folder / f"{name}.3mf"))
    assert model.GetUnit() == lib3mf.ModelUnit.MilliMeter
    bodies = model.GetMeshObjects()
    bodies.MoveNext()
    body = bodies.GetCurrentMeshObject()
    assert body.GetName() == body.GetPartNumber() == name
    group = body.GetMetaDataGroup()
    read = {(datum := group.GetMetaData(k)).GetName(): datum.GetValue() for k in range(group.GetMetaDataCount())}
    assert read == {key: str(value) for key, value in parts.parameters[name].items()}
    assert "cavity_diameter" in read
    whole = model.GetMetaDataGroup()
    stated = {(datum := whole.GetMetaData(k)).GetName(): datum.GetValue() for k in range(whole.GetMetaDataCount())}
    assert read_design(stated["design_toml"]) == read_design(parts.design_toml)


@pytest.mark.slow
def test_lib3mf_and_trimesh_read_the_plates(exported, tmp_path):
    parts, _, _ = exported
    plates = export_plates(parts, tmp_path, PROCESSES["sla-resin"]).plates
    printed = {name for plate in plates for name in plate.copies}
    assert printed == {name for name in parts if parts.origin(name) == "printed" and parts.counts[name]}
    for plate in plates:
        assert set(read_3mf(plate.path)) == set(plate.copies)
        scene = trimesh.load(plate.path)
        assert set(scene.geometry) == set(plate.copies)
        low, high = scene.bounds
        width, depth, _ = PROCESSES["sla-resin"].build_volume
        assert (low[:2] >= MARGIN - 1e-3).all()
        assert (high[:2] <= np.array([width, depth]) - MARGIN + 1e-3).all()
        assert low[:2] + high[:2] == pytest.approx((width, depth), abs=1e-3)


def test_3mf_opens_in_trimesh_with_unit_and_name(exported):
    parts, folder, _ = exported
    for name, part in parts.items():
        scene = trimesh.load(folder / f"{name}.3mf")
        assert scene.units == "millimeter"
        (mesh,) = scene.geometry.values()
        assert list(scene.geometry) == [name]
        assert mesh.is_volume
        assert mesh.volume == pytest.approx(part.val().Volume(), rel=1e-3)


def test_step_carries_the_name_and_the_exact_solid(exported):
    parts, folder, _ = exported
    for name, part in parts.items():
        path = folder / f"{name}.step"
        assert re.findall(r"PRODUCT\('([^']*)'", path.read_text()) == [name]
        read = cq.importers.importStep(str(path))
        assert read.solids().size() == 1
        assert read.solids().val().Volume() == pytest.approx(part.val().Volume(), rel=1e-9)


def test_the_tolerance_follows_the_narrowest_bore():
    array = built("array-2x6")
    assert tessellation_tolerance(array) == pytest.approx(0.44 / 50)
    assert tessellation_tolerance(box(plate=(10, 10, 0.5))) == pytest.approx(0.01)


@pytest.mark.parametrize(("tolerance", "angle"), [(1.0, 0.5), (1e-4, 0.02)])
def test_an_earlier_tessellation_is_not_reused(tolerance, angle, tmp_path):
    fresh, used = ({"rod": cq.Workplane().circle(1).extrude(1)} for _ in range(2))
    used["rod"].val().mesh(tolerance, angle)
    export(fresh, tmp_path / "fresh", ("stl",))
    export(used, tmp_path / "used", ("stl",))
    assert (tmp_path / "fresh/rod.stl").read_bytes() == (tmp_path / "used/rod.stl").read_bytes()


def test_a_change_of_tolerance_makes_new_facets(tmp_path):
    rod = {"rod": cq.Workplane().circle(20).extrude(1)}
    counts, deviations = [], []
    for tolerance in (0.01, 0.001, 0.01):
        (file,) = export(rod, tmp_path, ("stl",), tolerance)
        counts.append(file.triangles)
        deviations.append(file.linear_deviation)
        assert len(trimesh.load_mesh(file.path).faces) == file.triangles
        assert file.linear_deviation <= tolerance
    assert counts[1] > 1.5 * counts[0] == 1.5 * counts[2]
    assert deviations[1] < deviations[0]
    with refused(Kind.OUT_OF_RANGE, "tolerance", 0):
        export(rod, tmp_path, ("stl",), 0)


def test_a_coarse_tolerance_is_refined_until_the_volume_is_right(tmp_path):
    (file,) = export({"ball": cq.Workplane(cq.Solid.makeSphere(5, angleDegrees1=-90))}, tmp_path, ("stl",), 1.0)
    assert abs(file.volume_error) <= LARGEST_VOLUME_ERROR


def test_equal_shapes_are_written_once_with_their_count(tmp_path):
    parts = geometry.assembly.PartSet()
    ring = cq.Workplane().circle(2).circle(1).extrude(1)
    parts |= {
        "left": ring,
        "plate": cq.Workplane().box(1, 2, 3),
        "right": cq.Workplane().circle(2).circle(1).extrude(1),
    }
    parts.counts = {"left": 2, "plate": 1, "right": 3}
    files = export(parts, tmp_path, ("stl",))
    assert [(file.path.name, file.count, file.also) for file in files] == [
        ("left.stl", 5, ("right",)), ("plate.stl", 1, ()),
    ]  # fmt: skip
    assert sorted(path.name for path in tmp_path.iterdir()) == ["left.stl", "plate.stl"]


def test_plates_hold_every_printed_part_as_often_as_it_is_needed(tmp_path):
    parts = geometry.assembly.PartSet()
    parts |= {
        "block": cq.Workplane().box(10, 20, 3),
        "rod": cq.Workplane().circle(4).extrude(5),
        "membrane": cq.Workplane().circle(3).extrude(1),
        "beam": cq.Workplane().box(70, 3, 3),
    }
    parts.counts = {"block": 7, "rod": 3, "membrane": 9, "beam": 1}
    parts.parameters, parts.kinds = {"block": {"width": 10.0}}, {"membrane": "membrane"}
    process = with_rules(PROCESSES["sla-resin"], {"build_volume": (46, 51, 50)})
    made = export_plates(parts, tmp_path, process)
    assert made.too_large == ("beam",)
    assert [plate.copies for plate in made.plates] == [{"block": 6}, {"block": 1, "rod": 3}]
    for plate in made.plates:
        scene = trimesh.load(plate.path)
        assert scene.units == "millimeter"
        assert set(scene.geometry) == set(plate.copies)
        boxes = []
        for node in scene.graph.nodes_geometry:
            matrix, name = scene.graph[node]
            boxes.append(scene.geometry[name].copy().apply_transform(matrix).bounds)
        assert len(boxes) == sum(plate.copies.values())
        for k, (low, high) in enumerate(boxes):
            assert low == pytest.approx(np.maximum(low, 0), abs=1e-4)
            assert low[2] == pytest.approx(0, abs=1e-4)
            assert (high[:2] <= np.array([46, 51]) + 1e-4).all()
            for other_low, other_high in boxes[:k]:
                apart = np.maximum(low - other_high, other_low - high)[:2].max()
                assert apart >= MARGIN - 1e-4


def test_a_mesh_that_lost_a_bore_is_refused(tmp_path, monkeypatch):
    monkeypatch.setattr("geometry.solids.genus", lambda solid: 2)
    with refused(Kind.NO_RESULT, file="ring.stl"):
        export({"ring": cq.Workplane().circle(2).circle(1).extrude(1)}, tmp_path, ("stl",))


@pytest.mark.parametrize("solid", [cq.Solid.makeSphere(1), cq.Solid.makeCone(1, 0, 2)], ids=["sphere", "cone"])
def test_solids_with_poles_are_exported_without_empty_facets(solid, tmp_path):
    for file in export({"solid": cq.Workplane(solid)}, tmp_path, ("stl", "3mf")):
        assert abs(file.volume_error) < 2e-3


def test_measured_deviation_is_the_sagitta_of_a_cylinder():
    facets = tessellate(cq.Solid.makeCylinder(5, 1), 0.1, 0.2)
    rim = facets.vertices[np.isclose(np.hypot(facets.vertices[:, 0], facets.vertices[:, 1]), 5)]
    count = len(rim) // 2
    assert facets.deviation == pytest.approx(5 * (1 - np.cos(np.pi / count)), rel=1e-6)


@pytest.mark.parametrize(
    ("parts", "formats", "kind", "field"),
    [
        (box(a=(1, 1, 1)), ("obj",), Kind.UNKNOWN, "formats"),
        ({}, ("stl",), Kind.MISSING, "parts"),
        (box(a=(1, 1, 1)), (), Kind.MISSING, "formats"),
        ({"../a": cq.Workplane().box(1, 1, 1)}, ("stl",), Kind.OUT_OF_RANGE, "parts"),
        (
            {
                "pair": cq.Workplane(
                    cq.Compound.makeCompound([cq.Solid.makeBox(1, 1, 1), cq.Solid.makeBox(1, 1, 1, cq.Vector(2, 0, 0))])
                )
            },
            ("stl",),
            Kind.UNSUITABLE,
            "parts.pair",
        ),
    ],
)
def test_what_cannot_be_exported_is_refused(parts, formats, kind, field, tmp_path):
    with refused(kind, field):
        export(parts, tmp_path / "out", formats)
    assert not list(tmp_path.rglob("*.*"))


@pytest.mark.parametrize("format_", ["stl", "3mf"])
def test_a_file_with_the_wrong_volume_is_refused_and_the_old_one_kept(format_, tmp_path, monkeypatch):
    (tmp_path / f"rod.{format_}").write_text("old")
    monkeypatch.setattr(part_files, "LARGEST_VOLUME_ERROR", 1e-9)
    with refused(Kind.NO_RESULT, file=f"rod.{format_}"):
        export({"rod": cq.Workplane().circle(1).extrude(1)}, tmp_path, (format_,))
    assert [path.name for path in tmp_path.iterdir()] == [f"rod.{format_}"]
    assert (tmp_path / f"rod.{format_}").read_text() == "old"


def test_a_mesh_with_a_hole_is_refused(tmp_path, monkeypatch):
    whole = part_files._mesh

    def torn(facets):
        mesh = whole(facets)
        mesh.update_faces(np.arange(len(mesh.faces)) > 0)
        return mesh

    monkeypatch.setattr(part_files, "_mesh", torn)
    with refused(Kind.NO_RESULT, file="rod.stl"):
        export({"rod": cq.Workplane().circle(1).extrude(1)}, tmp_path, ("stl",))
    assert not list(tmp_path.iterdir())
