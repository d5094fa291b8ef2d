"""3MF files: bodies with their unit, names, part numbers and generating parameters, in one or many places."""

from __future__ import annotations

import json
import uuid
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from geometry.ground.record import sha256
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array

if TYPE_CHECKING:
    import trimesh

    from geometry.solids.measure import Tessellation

#: Namespace of our metadata.
_NAMESPACE = "urn:acoustic-fem:part"


@dataclass(frozen=True)
class Body:
    """A part as it is written: once, however many copies are placed."""

    name: str
    """Name of the part."""
    facets: Tessellation
    """Facets in the part's own coordinates, mm."""
    parameters: Mapping[str, Any] = field(default_factory=dict)
    """Parameters that the part was generated from."""
    places: tuple[Array, ...] = (np.eye(4),)
    """How each copy is turned and moved, (4, 4) float64 matrices, mm."""


def write_3mf(bodies: Sequence[Body], title: str, path: Path, *, design_toml: str = "") -> None:
    """Write bodies, lengths in mm.

    Args:
        bodies: the bodies; no two of one name.
        title: title of the file.
        path: of the file; its folder must exist.
        design_toml: text of the design that the bodies belong to. It stands once, at the head of the model: lib3mf
            cannot read an escaped quote that lies over the end of one of its buffers of 64 kB (its issue 221).
    """
    import lib3mf

    seed = _seed(bodies, title, design_toml)
    wrapper = lib3mf.get_wrapper()
    model = wrapper.CreateModel()
    model.SetUnit(lib3mf.ModelUnit.MilliMeter)
    model.SetBuildUUID(_uuid(seed, "build"))
    model.GetMetaDataGroup().AddMetaData("", "Title", title, "xs:string", True)
    model.GetMetaDataGroup().AddMetaData("", "Application", "acoustic-fem", "xs:string", True)
    if design_toml:
        model.GetMetaDataGroup().AddMetaData(_NAMESPACE, "design_toml", design_toml, "xs:string", True)
    for body in bodies:
        mesh = model.AddMeshObject()
        mesh.SetUUID(_uuid(seed, f"body {body.name}"))
        mesh.SetName(body.name)
        mesh.SetPartNumber(body.name)
        for key, value in body.parameters.items():
            mesh.GetMetaDataGroup().AddMetaData(_NAMESPACE, key, str(value), "xs:string", True)
        mesh.SetGeometry(
            [_filled(lib3mf.Position(), vertex) for vertex in body.facets.vertices.tolist()],
            [_filled(lib3mf.Triangle(), corners) for corners in body.facets.triangles.tolist()],
        )
        for copy, place in enumerate(body.places):
            transform = lib3mf.Transform()
            for row, numbers in zip(transform.Fields, place[:3].T.tolist(), strict=True):  # coordinates are rows there
                row[:] = numbers
            model.AddBuildItem(mesh, transform).SetUUID(_uuid(seed, f"copy {copy} of {body.name}"))
    writer = model.QueryWriter("3mf")
    writer.SetDecimalPrecision(7)
    writer.WriteToFile(str(path))


def _seed(bodies: Sequence[Body], title: str, design_toml: str) -> str:
    """Hash of all that a file holds: equal files have equal identifiers, others have others."""
    stated: list[bytes] = [title.encode(), design_toml.encode()]
    for body in bodies:
        parameters = [[key, str(value)] for key, value in body.parameters.items()]
        stated.append(json.dumps([body.name, parameters]).encode())
        stated += [np.ascontiguousarray(each).tobytes() for each in (body.facets.vertices, body.facets.triangles)]
        stated += [np.ascontiguousarray(place).tobytes() for place in body.places]
    return sha256(*stated)


def _uuid(seed: str, what: str) -> str:
    return str(uuid.uuid5(uuid.NAMESPACE_URL, f"{_NAMESPACE}:{seed}:{what}"))


def read_3mf(path: Path) -> dict[str, trimesh.Trimesh]:
    """The bodies of a file in mm by name, as written, wherever they are placed.

    Raises:
        Refusal: another unit, or two bodies of one name.
    """
    import lib3mf
    import trimesh

    model = lib3mf.get_wrapper().CreateModel()
    model.QueryReader("3mf").ReadFromFile(str(path))
    if model.GetUnit() != lib3mf.ModelUnit.MilliMeter:
        raise Refusal("is in another unit than mm", kind=Kind.UNSUITABLE, file=path)
    found: dict[str, trimesh.Trimesh] = {}
    bodies = model.GetMeshObjects()
    while bodies.MoveNext():
        body = bodies.GetCurrentMeshObject()
        if body.GetName() in found:
            raise Refusal(f"has two bodies called {body.GetName()!r}", kind=Kind.UNSUITABLE, file=path)
        found[body.GetName()] = trimesh.Trimesh(
            np.array([list(vertex.Coordinates) for vertex in body.GetVertices()]),
            np.array([list(triangle.Indices) for triangle in body.GetTriangleIndices()]),
            process=False,
        )
    return found


def _filled(record: Any, numbers: list[Any]) -> Any:
    (entry,) = (getattr(record, name) for name, _ in record._fields_)
    for index, number in enumerate(numbers):
        entry[index] = number
    return record
