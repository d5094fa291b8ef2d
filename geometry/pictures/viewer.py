"""The array as a model to turn on the screen: glTF (.glb) for other programs, and one HTML page that opens offline."""

from __future__ import annotations

import base64
import json
import os
from collections.abc import Mapping
from importlib import resources
from pathlib import Path

import numpy as np
import trimesh
from trimesh.visual.material import PBRMaterial

import geometry
from geometry.assembly.model import LOOKS, ArrayModel, array_model
from geometry.assembly.order_table import assembly_steps, assembly_text
from geometry.design.array_design import ArrayDesign
from geometry.ground.page_parts import page_parts
from geometry.ground.refusal import counted
from geometry.ground.whole_files import made_folder, whole_file
from geometry.layout.overlaps import schematic_notes
from geometry.layout.size import array_size
from geometry.solids.measure import Tessellation

#: Facets for the eye: within this part of a shape's size and this angle (rad).
_DEVIATION, _FACET_ANGLE = 0.002, 0.35
#: Colour and opacity of the body that an array lies on.
_BODY_LOOK = ("#c9c4ba", 0.35)


def write_gltf(
    array: ArrayDesign | ArrayModel, path: str | os.PathLike[str], bodies: Mapping[str, Tessellation] | None = None
) -> Path:
    """Write the array as binary glTF: metres, y up, one node per part by its label, each shape stored once.

    Args:
        array: the design, or what :func:`geometry.assembly.model.array_model` put together of it already.
        path: of the ``.glb`` file; an existing one is replaced only by a complete one.
        bodies: facets of the body that it lies on and of its skin, by the name of their node.
    """
    return _whole(path, _gltf(array_model(array), bodies or {}))


def write_viewer(
    array: ArrayDesign | ArrayModel, path: str | os.PathLike[str], bodies: Mapping[str, Tessellation] | None = None
) -> Path:
    """Write one HTML page that shows the array in any browser, without a network: turn, zoom, hide kinds of parts.

    The page holds the model as glTF and draws it as the studio does, with three.js (MIT licence).

    Args:
        array: the design, or what :func:`geometry.assembly.model.array_model` put together of it already.
        path: of the page; an existing one is replaced only by a complete one.
        bodies: facets of the body that it lies on and of its skin, by the name of their node.
    """
    import jinja2

    model = array_model(array)
    design = model.design
    shown = {
        "file": f"data:model/gltf-binary;base64,{base64.b64encode(_gltf(model, bodies or {})).decode('ascii')}",
        "parts": [
            *({"label": _node(p.label), "part": p.part, "kind": p.kind, "group": p.group} for p in model.placed),
            *({"label": name, "part": name, "kind": name, "group": name} for name in bodies or {}),
        ],
        "size": list(array_size(design, model.layout)),
        "notes": list(schematic_notes(design, model.layout)),
    }
    template = (resources.files(geometry) / "templates" / "array-page.html").read_text(encoding="utf-8")
    style, script = page_parts("array-page")
    environment = jinja2.Environment(autoescape=True, undefined=jinja2.StrictUndefined)
    page = environment.from_string(template).render(
        name=design.name,
        facts=f"{counted(design.point_count, 'point')}, {counted(len(design.microphones), 'microphone')}",
        table=assembly_text(design, assembly_steps(model)),
        style=style,
        script=script,
        # JSON reads the escaped sign as the plain one, and no label ends the element too early.
        model=json.dumps({"name": design.name, "model": shown}, separators=(",", ":")).replace("<", "\\u003c"),
    )
    return _whole(path, page.encode())


def _gltf(model: ArrayModel, bodies: Mapping[str, Tessellation]) -> bytes:
    """The array as binary glTF: metres with y up; ours is in millimetres with z up."""
    to_gltf = np.array([[1, 0, 0, 0], [0, 0, 1, 0], [0, -1, 0, 0], [0, 0, 0, 1000]]) / 1000
    content: bytes = _scene(model, to_gltf, bodies).export(file_type="glb")
    return content


def _scene(model: ArrayModel, outer: np.ndarray, bodies: Mapping[str, Tessellation]) -> trimesh.Scene:
    """Every shape once as triangles, every placed part and every body as a node."""
    scene = trimesh.Scene(base_frame="array")
    for name, own in bodies.items():
        scene.geometry[name] = _shaded(own, _material(name, *_BODY_LOOK))
        scene.graph.update(frame_to=name, frame_from="array", matrix=outer, geometry=name)
    for part in model.placed:
        if part.part not in scene.geometry:
            shape = model.shapes[part.part]
            low, high = geometry.solids.quick_box(shape)
            fine = _DEVIATION * float(np.linalg.norm(high - low))
            facets = geometry.solids.tessellate(shape, fine, _FACET_ANGLE, measured=False)
            scene.geometry[part.part] = _shaded(facets, _material(part.kind, *LOOKS[part.kind]))
        scene.graph.update(
            frame_to=_node(part.label), frame_from="array", matrix=outer @ part.matrix, geometry=part.part
        )
    return scene


def _shaded(facets: Tessellation, material: PBRMaterial) -> trimesh.Trimesh:
    """Facets whose corners are not shared where faces meet at an edge, so that edges stay sharp."""
    mesh = trimesh.Trimesh(facets.vertices, facets.triangles, process=False)
    mesh = trimesh.graph.smooth_shade(mesh, angle=np.radians(30))
    mesh.visual = trimesh.visual.TextureVisuals(material=material)
    return mesh


def _node(label: str) -> str:
    """A label as the name of a node; three.js allows no blanks in names."""
    return label.replace(" ", "_")


def _material(name: str, colour: str, opacity: float) -> PBRMaterial:
    # glTF's factors are linear in light, colours as written on pages are not (sRGB, IEC 61966-2-1).
    red, green, blue = (round(255 * (int(colour[k : k + 2], 16) / 255) ** 2.2) for k in (1, 3, 5))
    return PBRMaterial(
        name=name,
        baseColorFactor=[red, green, blue, round(255 * opacity)],
        alphaMode="OPAQUE" if opacity == 1 else "BLEND",
        metallicFactor=0.0,
        roughnessFactor=0.7,
        doubleSided=opacity < 1,
    )


def _whole(path: str | os.PathLike[str], content: bytes) -> Path:
    path = Path(path)
    made_folder(path.parent)
    with whole_file(path) as beside:
        beside.write_bytes(content)
    return path
