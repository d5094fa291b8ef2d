"""Files of bodies that crash, stop or flood what reads them."""

from __future__ import annotations

import io
import os
import random
import struct
import zipfile
from collections.abc import Callable
from pathlib import Path

from hostile.damage import Change, written

_STEP = "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n{data}\nENDSEC;\nEND-ISO-10303-21;\n"
_PLY = """ply
format {form} 1.0
element vertex {count}
property float x
property float y
property float z
element face {count}
property list uchar int vertex_indices
end_header
"""
_TYPES = (
    '<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">'
    '<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>'
)
_MODEL = (
    '<?xml version="1.0"?>{head}<model xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>'
)
_TETRAHEDRON = (
    '<object id="1" type="model"><mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="9" y="0" z="0"/>'
    '<vertex x="0" y="9" z="0"/><vertex x="0" y="0" z="9"/></vertices><triangles><triangle v1="0" v2="2" v3="1"/>'
    '<triangle v1="0" v2="1" v3="3"/><triangle v1="0" v2="3" v3="2"/><triangle v1="1" v2="2" v3="3"/></triangles>'
    "</mesh></object>"
)
_ENTITIES = "".join(f'<!ENTITY {name} "{f"&{before};" * 30}">' for before, name in zip("abcdef", "bcdefg", strict=True))


def _three_mf(name: str, model: Callable[[], str]) -> Change:
    """A 3MF file with the text of a model."""

    def change(folder: Path, draw: random.Random) -> None:
        packed = io.BytesIO()
        with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr("[Content_Types].xml", _TYPES)
            archive.writestr("3D/3dmodel.model", model())
        (folder / name).write_bytes(packed.getvalue())

    return change


def _of_assemblies() -> str:
    """Ten thousand million tetrahedra: assemblies of ten assemblies each."""
    levels = (
        f'<object id="{k}" type="model"><components>{f"""<component objectid="{k - 1}"/>""" * 10}</components></object>'
        for k in range(2, 12)
    )
    tail = '</resources><build><item objectid="11"/></build></model>'
    return _MODEL.format(head="") + _TETRAHEDRON + "".join(levels) + tail


def _coordinates(value: str) -> Change:
    def change(folder: Path, draw: random.Random) -> None:
        text = (folder / "box.step").read_text(encoding="utf-8")
        (folder / "bad.step").write_text(text.replace("(-2.,-1.5,-1.)", f"({value},-1.5,-1.)"), encoding="utf-8")

    return change


def _material_from_a_pipe(folder: Path, draw: random.Random) -> None:
    os.mkfifo(folder / "pipe.mtl")
    (folder / "bad.obj").write_text("mtllib pipe.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")


#: What is wrong, the file, and what makes it.
BODIES: tuple[tuple[str, str, Change], ...] = (
    ("deep parentheses", "bad.step", written("bad.step", _STEP.format(data=f"#1 = X({'(' * 10**5}{')' * 10**5});"))),
    ("open parentheses", "bad.step", written("bad.step", _STEP.format(data="#1 = POINT(" + "(" * 10**6))),
    ("a circle of references", "bad.step", written("bad.step", _STEP.format(data="#1 = PRODUCT('a','a','',(#1));"))),
    *((f"a coordinate of {value}", "bad.step", _coordinates(value)) for value in ("nan", "-INF", "1.E300")),
    ("a gigabyte of blanks", "bad.3mf", _three_mf("bad.3mf", lambda: _MODEL.format(head="") + " " * 10**9)),
    ("entities of entities", "bad.3mf", _three_mf(
        "bad.3mf", lambda: _MODEL.format(head=f'<!DOCTYPE m [<!ENTITY a "{"a" * 1000}">{_ENTITIES}]>') + "&g;</model>"
    )),
    ("assemblies of assemblies", "bad.3mf", _three_mf("bad.3mf", _of_assemblies)),
    ("an object within itself", "bad.3mf", _three_mf("bad.3mf", lambda: (
        _MODEL.format(head="") + '<object id="1"><components><component objectid="1"/></components></object>'
        '</resources><build><item objectid="1"/></build></model>'
    ))),
    ("10^12 corners claimed", "bad.ply", written("bad.ply", _PLY.format(form="binary_little_endian", count=10**12))),
    ("10^9 lines claimed", "bad.ply", written("bad.ply", _PLY.format(form="ascii", count=10**9))),
    ("fewer than no corners", "bad.ply", written("bad.ply", _PLY.format(form="ascii", count=-5))),
    ("4 * 10^9 facets claimed", "bad.stl", written("bad.stl", bytes(80) + struct.pack("<I", 2**32 - 1) + bytes(50))),
    ("zeros", "bad.stl", written("bad.stl", bytes(80) + struct.pack("<I", 10**5) + bytes(5 * 10**6))),
    ("a corner that is not there", "bad.obj", written("bad.obj", "v 0 0 0\nf 1 2 999999999999\n")),
    ("a material from a pipe", "bad.obj", _material_from_a_pipe),
)  # fmt: skip
