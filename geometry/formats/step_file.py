"""STEP files of assemblies, as the CAD kernel writes them, with the time that the program states."""

from __future__ import annotations

from pathlib import Path

from OCP.APIHeaderSection import APIHeaderSection_MakeHeader
from OCP.IFSelect import IFSelect_ReturnStatus
from OCP.Interface import Interface_Static
from OCP.StepBasic import StepBasic_Product
from OCP.STEPCAFControl import STEPCAFControl_Writer
from OCP.STEPControl import STEPControl_StepModelType
from OCP.StepData import StepData_StepModel
from OCP.StepRepr import StepRepr_NextAssemblyUsageOccurrence
from OCP.TCollection import TCollection_HAsciiString
from OCP.TDocStd import TDocStd_Document

from geometry.ground.refusal import Kind, Refusal
from geometry.ground.stated_times import stated_time

#: Beginning of the names that the CAD kernel gives to products without one, and the name that they get here.
_KERNELS_NAME, _UNNAMED = "Open CASCADE STEP translator", "acoustic-fem"


def write_document(document: TDocStd_Document, path: Path, *, named: Path) -> None:
    """Write shapes with their names and colours, in mm.

    Args:
        document: of CadQuery's ``toCAF``.
        path: of the file; its folder must exist.
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
    header.SetTimeStamp(TCollection_HAsciiString(stated_time().strftime("%Y-%m-%dT%H:%M:%S+00:00")))
    if writer.Write(str(path)) != IFSelect_ReturnStatus.IFSelect_RetDone:
        raise Refusal("cannot be written by the CAD kernel", kind=Kind.NO_RESULT, file=named)


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
