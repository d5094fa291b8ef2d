"""STEP files of parts and assemblies, as the CAD kernel writes them, with the time that the program states."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING

from OCP.APIHeaderSection import APIHeaderSection_MakeHeader
from OCP.BRepBuilderAPI import BRepBuilderAPI_Transform
from OCP.IFSelect import IFSelect_ReturnStatus
from OCP.Interface import Interface_Static
from OCP.StepBasic import StepBasic_Product
from OCP.STEPCAFControl import STEPCAFControl_Writer
from OCP.STEPControl import STEPControl_StepModelType
from OCP.StepData import StepData_StepModel
from OCP.StepRepr import StepRepr_NextAssemblyUsageOccurrence
from OCP.TCollection import TCollection_ExtendedString, TCollection_HAsciiString
from OCP.TDataStd import TDataStd_Name
from OCP.TDocStd import TDocStd_Document
from OCP.TopLoc import TopLoc_Location
from OCP.XCAFApp import XCAFApp_Application
from OCP.XCAFDoc import XCAFDoc_DocumentTool

from geometry.ground.refusal import Kind, Refusal
from geometry.ground.stated_times import stated_time

if TYPE_CHECKING:
    import cadquery as cq

#: Beginning of the names that the CAD kernel gives to products without one, and the name that they get here.
_KERNELS_NAME, _UNNAMED = "Open CASCADE STEP translator", "acoustic-fem"

#: Begins the colour of one shape; these come last in a file, in the order of the shapes' addresses in memory.
_STYLES = b" = MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION("
_END = b"ENDSEC;\nEND-ISO-10303-21;\n"
_NUMBER = re.compile(rb"#(\d+)")


def part_document(shape: cq.Shape, name: str) -> TDocStd_Document:
    """Document of one part, which bears its name and lies in no assembly."""
    document = TDocStd_Document(TCollection_ExtendedString("XmlOcaf"))
    XCAFApp_Application.GetApplication_s().InitDocument(document)
    tool = XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    solids = shape.Solids()  # a compound of one solid would be written as an assembly
    alone = (solids[0] if len(solids) == 1 else shape).wrapped
    # so would a shape that is moved, unless its surfaces are
    still = BRepBuilderAPI_Transform(alone.Located(TopLoc_Location()), alone.Location().Transformation(), True).Shape()
    TDataStd_Name.Set_s(tool.AddShape(still, False), TCollection_ExtendedString(name))
    return document


def write_document(document: TDocStd_Document, path: Path, *, title: str, named: Path) -> None:
    """Write shapes with their names and colours, in mm.

    Args:
        document: of :func:`part_document`, or of CadQuery's ``toCAF``.
        path: of the file; its folder must exist.
        title: name of the part or of the array.
        named: the file as its reader will call it, for messages.

    Raises:
        Refusal: the CAD kernel cannot write it.
    """
    writer = STEPCAFControl_Writer()
    writer.SetColorMode(True)
    writer.SetLayerMode(True)
    writer.SetNameMode(True)
    Interface_Static.SetCVal_s("xstep.cascade.unit", "MM")
    Interface_Static.SetCVal_s("write.step.unit", "MM")
    Interface_Static.SetIVal_s("write.surfacecurve.mode", 1)
    Interface_Static.SetIVal_s("write.precision.mode", 0)
    writer.Transfer(document, STEPControl_StepModelType.STEPControl_AsIs)
    model = writer.ChangeWriter().Model()
    _number(model)
    header = APIHeaderSection_MakeHeader(model)
    header.SetName(TCollection_HAsciiString(title))
    header.SetAuthorValue(1, TCollection_HAsciiString(_UNNAMED))
    header.SetOrganizationValue(1, TCollection_HAsciiString(_UNNAMED))
    header.SetOriginatingSystem(TCollection_HAsciiString(_UNNAMED))
    header.SetTimeStamp(TCollection_HAsciiString(stated_time().strftime("%Y-%m-%dT%H:%M:%S+00:00")))
    if writer.Write(str(path)) != IFSelect_ReturnStatus.IFSelect_RetDone:
        raise Refusal("cannot be written by the CAD kernel", kind=Kind.NO_RESULT, file=named)
    path.write_bytes(_with_styles_in_order(path.read_bytes()))


def _number(model: StepData_StepModel) -> None:
    """Number instances from 1: the CAD kernel counts them, and products without a name, on from file to file."""
    count = 0
    for index in range(1, model.NbEntities() + 1):
        entity = model.Value(index)
        if isinstance(entity, StepRepr_NextAssemblyUsageOccurrence):
            count += 1
            entity.SetId(TCollection_HAsciiString(str(count)))
        elif isinstance(entity, StepBasic_Product) and entity.Name().ToCString().startswith(_KERNELS_NAME):
            entity.SetId(TCollection_HAsciiString(_UNNAMED))
            entity.SetName(TCollection_HAsciiString(_UNNAMED))


def _with_styles_in_order(text: bytes) -> bytes:
    """A STEP file whose colours follow the order of the shapes in the file, with the numbers of their lines.

    Raises:
        RuntimeError: the CAD kernel writes colours elsewhere.
    """
    first = text.rfind(b"\n", 0, text.find(_STYLES)) + 1 if _STYLES in text else text.rfind(_END)
    body, styles = text[:first], text[first:].removesuffix(_END)
    lines: dict[int, bytes] = {}
    for line in re.sub(rb"\n\s*", b"", styles).split(b";")[:-1]:
        number, _, entity = line.partition(b" = ")
        lines[int(number[1:])] = entity
    if not text.endswith(_END) or max(map(int, _NUMBER.findall(body)), default=0) >= min(lines, default=1 << 62):
        raise RuntimeError("the CAD kernel's STEP files have changed: colours are not the last lines")

    def shape(number: int) -> int:
        return max(each for each in _reached(number, lines) if each not in lines)

    roots = sorted((number for number in lines if lines[number].startswith(_STYLES.removeprefix(b" = "))), key=shape)
    order = dict.fromkeys(number for root in roots for number in _reached(root, lines) if number in lines)
    new = {old: min(lines) + place for place, old in enumerate(order)}

    def renumbered(found: re.Match[bytes]) -> bytes:
        return b"#%d" % new.get(int(found[1]), int(found[1]))

    written = [b"#%d = %s;\n" % (new[old], _NUMBER.sub(renumbered, lines[old])) for old in order]
    return body + b"".join(written) + _END


def _reached(number: int, lines: dict[int, bytes]) -> dict[int, None]:
    """A line and the lines that it refers to, in their order; those without an entry in ``lines`` lead no further."""
    found: dict[int, None] = {}
    waiting = [number]
    while waiting:
        at = waiting.pop()
        if at not in found:
            found[at] = None
            waiting += reversed([int(each) for each in _NUMBER.findall(lines.get(at, b""))])
    return found
