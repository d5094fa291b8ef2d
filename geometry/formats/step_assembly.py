"""The array as a STEP file: products named after the parts, instances after where they are."""

from __future__ import annotations

import os
from pathlib import Path

from cadquery.occ_impl.assembly import toCAF
from OCP.TCollection import TCollection_ExtendedString
from OCP.TDataStd import TDataStd_Name
from OCP.TDF import TDF_Label, TDF_LabelSequence
from OCP.XCAFDoc import XCAFDoc_ShapeTool

from geometry.assembly.model import ArrayModel, assembly_of, component_name
from geometry.formats.step_document import write_document
from geometry.ground.whole_files import whole_file


def write_step(model: ArrayModel, path: str | os.PathLike[str]) -> Path:
    """Write an array put together as STEP, in mm: groups, in them named copies, every shape once.

    The export of a CadQuery assembly calls every product by the copy that came first, and groups by a number. Here
    the shell of point 3 is the instance ``shell 3`` of the product ``shell-straight`` in the group ``point 3``.

    Args:
        model: of :func:`geometry.assembly.model.array_model`.
        path: of the file; its folder must exist. An existing one is replaced only by a complete one.

    Raises:
        Refusal: the CAD kernel cannot write it.
        OSError: the file cannot be written.
    """
    root, document = toCAF(assembly_of(model), coloredSTEP=True)
    parts = {component_name(model, part): part.part for part in model.placed}

    for group, product in _components(root):
        _rename(group, _name(product))
        for copy, shape in _components(product):
            _rename(shape, parts[_name(copy)])
    path = Path(path)
    with whole_file(path) as beside:
        write_document(document, beside, title=model.design.name, named=path)
    return path


def _components(assembly: TDF_Label) -> list[tuple[TDF_Label, TDF_Label]]:
    """Instances in an assembly and the product of each."""
    whole = TDF_Label()
    if XCAFDoc_ShapeTool.GetReferredShape_s(assembly, whole):
        assembly = whole
    found, pairs = TDF_LabelSequence(), []
    XCAFDoc_ShapeTool.GetComponents_s(assembly, found, False)
    for index in range(1, found.Length() + 1):
        product = TDF_Label()
        XCAFDoc_ShapeTool.GetReferredShape_s(found.Value(index), product)
        pairs.append((found.Value(index), product))
    return pairs


def _name(label: TDF_Label) -> str:
    name = TDataStd_Name()
    return str(name.Get().ToExtString()) if label.FindAttribute(TDataStd_Name.GetID_s(), name) else ""


def _rename(label: TDF_Label, name: str) -> None:
    TDataStd_Name.Set_s(label, TCollection_ExtendedString(name))
