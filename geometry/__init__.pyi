from . import (
    air as air,
    assembly as assembly,
    boards as boards,
    body as body,
    design as design,
    formats as formats,
    ground as ground,
    layout as layout,
    molds as molds,
    pictures as pictures,
    plan as plan,
    printing as printing,
    schema as schema,
    solids as solids,
    stock as stock,
    surface as surface,
)
from .assembly.bill import bill_of_materials as bill_of_materials
from .assembly.model import build_assembly as build_assembly
from .assembly.part_list import build_parts as build_parts
from .design.array_design import ArrayDesign as ArrayDesign
from .design.design_file import (
    DesignLike as DesignLike,
    load_design as load_design,
    prototype as prototype,
    prototype_names as prototype_names,
    resolve_design as resolve_design,
    save_design as save_design,
)
from .formats.part_files import export as export
from .ground.refusal import Kind as Kind, Refusal as Refusal
from .printing.printability import print_report as print_report
from .schema.field_errors import DesignError as DesignError
