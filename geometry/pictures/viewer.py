"""The array as a model to turn on the screen: glTF (.glb) for other programs, and one HTML page that opens offline."""

from __future__ import annotations

import html
import json
import os
from collections.abc import Mapping
from pathlib import Path

import numpy as np
import trimesh
from trimesh.viewer import scene_to_html
from trimesh.visual.material import PBRMaterial

import geometry
from geometry.assembly.model import LOOKS, ArrayModel, PartKind, array_model
from geometry.assembly.order_table import assembly_steps, assembly_text
from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import counted
from geometry.ground.whole_files import made_folder, whole_file
from geometry.solids.measure import Tessellation

#: Facets for the eye: within this part of a shape's size and this angle (rad).
_DEVIATION, _FACET_ANGLE = 0.002, 0.35
#: Turns of the page's first view about x, y and z, rad: from above and in front.
_SEEN_FROM = (0.7, 0.0, 0.0)
#: Field of view across and up, degrees.
_FIELD_OF_VIEW = (60.0, 45.0)
#: Room at the sides of that view, as a factor.
_ROOM = 1.1
#: Colour and opacity of the body that an array lies on.
_BODY_LOOK = ("#c9c4ba", 0.35)
_NAMES: dict[PartKind, str] = {
    "base": "base plate",
    "shell": "shells",
    "membrane": "membranes",
    "sheath": "tube sheaths",
    "spring": "tube springs",
    "housing": "microphone housings",
    "board": "boards",
    "package": "microphones",
}


def write_gltf(
    array: ArrayDesign | ArrayModel, path: str | os.PathLike[str], bodies: Mapping[str, Tessellation] | None = None
) -> Path:
    """Write the array as binary glTF: metres, y up, one node per part by its label, each shape stored once.

    Args:
        array: the design, or what :func:`geometry.assembly.model.array_model` put together of it already.
        path: of the ``.glb`` file; an existing one is replaced only by a complete one.
        bodies: facets of the body that it lies on and of its skin, by the name of their node.
    """
    # glTF is in metres with y up; ours is in millimetres with z up.
    to_gltf = np.array([[1, 0, 0, 0], [0, 0, 1, 0], [0, -1, 0, 0], [0, 0, 0, 1000]]) / 1000
    return _whole(path, _scene(array_model(array), to_gltf, bodies or {}).export(file_type="glb"))


def write_viewer(
    array: ArrayDesign | ArrayModel, path: str | os.PathLike[str], bodies: Mapping[str, Tessellation] | None = None
) -> Path:
    """Write one HTML page that shows the array in any browser, without a network: turn, zoom, hide kinds of parts.

    The page holds the model as glTF and trimesh's viewer, which is made with three.js (both MIT licence).

    Args:
        array: the design, or what :func:`geometry.assembly.model.array_model` put together of it already.
        path: of the page; an existing one is replaced only by a complete one.
        bodies: facets of the body that it lies on and of its skin, by the name of their node.
    """
    model = array_model(array)
    design = model.design
    bodies = bodies or {}
    scene = _scene(model, np.eye(4), bodies)
    scene.camera = trimesh.scene.cameras.Camera(name="camera", fov=_FIELD_OF_VIEW)  # else its name is a random one
    scene.set_camera(angles=_SEEN_FROM, fov=_FIELD_OF_VIEW)
    page = scene_to_html(scene)
    # The page's own title and switches go beside trimesh's canvas; its three.js objects carry our labels.
    kinds = [kind for kind in _NAMES if any(part.kind == kind for part in model.placed)]
    labels = {kind: [_node(p.label) for p in model.placed if p.kind == kind] for kind in kinds}
    switches = "".join(
        f'<label><input type="checkbox" checked data-kind="{kind}"> '
        f'<b style="color:{LOOKS[kind][0]}">&#9632;</b> {_NAMES[kind]} ({len(labels[kind])})</label><br>'
        for kind in kinds
    ) + "".join(
        f'<label><input type="checkbox" checked data-kind="{name}"> '
        f'<b style="color:{_BODY_LOOK[0]}">&#9632;</b> {name}</label><br>'
        for name in bodies
    )
    panel = _PANEL.format(
        name=html.escape(design.name),
        facts=html.escape(f"{counted(design.point_count, 'point')}, {counted(len(design.microphones), 'microphone')}"),
        switches=switches,
        table=html.escape(assembly_text(design, assembly_steps(model))),
        labels=json.dumps(labels | {name: [name] for name in bodies}),
        names=json.dumps({_node(part.label): part.label for part in model.placed} | {name: name for name in bodies}),
        aspect=f"{_ROOM * _aspect(scene):.4f}",
    )
    title = f"<title>{html.escape(design.name)}</title>"
    for old, new in (("<title>trimesh: threejs viewer</title>", title), ("</body>", panel + "</body>")):
        if page.count(old) != 1:
            raise RuntimeError(f"trimesh's viewer page has changed: {old!r} appears {page.count(old)} times")
        page = page.replace(old, new)
    return _whole(path, page.encode())


_PANEL = """<div style="position:fixed;left:12px;top:12px;font:14px sans-serif;background:#fffc;padding:8px">
<b>{name}</b><br>{facts}<br><small>drag: turn; wheel: zoom; right button: move; point at a part for its name</small><br>
<b id="pointed">&nbsp;</b><br>{switches}
<details><summary>which part goes where</summary>
<pre style="max-height:60vh;max-width:90vw;overflow:auto;font-size:12px">{table}</pre></details></div>
<script>
const partsOfKind = {labels}, nameOfPart = {names};
scene.background = new THREE.Color(0xf4f5f7);
scene.add(new THREE.HemisphereLight(0xffffff, 0x9aa0a8, 0.9));
tracklight.intensity = 0.9;
renderer.outputEncoding = THREE.sRGBEncoding;
// The first view fits a window of this shape; in a narrower one the angle of view grows, so that nothing is cut.
const fitted = {aspect};
let upright = null;
const resized = onWindowResize;
onWindowResize = function () {{
  if (upright === null) upright = Math.tan(camera.fov * Math.PI / 360);
  const wider = Math.max(1, fitted * window.innerHeight / window.innerWidth);
  camera.fov = 360 / Math.PI * Math.atan(upright * wider);
  resized();
}};
// A page that was ready before this script has called and bound the old one.
if (camera) {{
  window.removeEventListener("resize", resized);
  window.addEventListener("resize", onWindowResize);
  onWindowResize();
}}
const partOf = (each) => each === null || each.name in nameOfPart ? each : partOf(each.parent);
const pointer = new THREE.Raycaster();
renderer.domElement.addEventListener("mousemove", (event) => {{
  if (!camera || event.buttons) return;
  const at = new THREE.Vector2(2 * event.clientX / window.innerWidth - 1, 1 - 2 * event.clientY / window.innerHeight);
  pointer.setFromCamera(at, camera);
  const parts = pointer.intersectObjects(scene.children, true).map((hit) => partOf(hit.object));
  const part = parts.find((each) => each && each.visible);
  document.getElementById("pointed").textContent = part ? nameOfPart[part.name] : "\u00a0";
}});
for (const box of document.querySelectorAll("input[data-kind]")) {{
  box.addEventListener("change", () => {{
    for (const name of partsOfKind[box.dataset.kind]) {{
      const part = scene.getObjectByName(name);
      if (part) part.visible = box.checked;
    }}
    render();
  }});
}}
</script>
"""


def _aspect(scene: trimesh.Scene) -> float:
    """Width over height of what the camera of a scene sees."""
    across, up = np.tan(np.radians(scene.camera.fov) / 2)
    return float(across / up)


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
