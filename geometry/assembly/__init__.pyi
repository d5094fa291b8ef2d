from .bill import Bill as Bill, Prices as Prices, bill_of_materials as bill_of_materials, write_bill as write_bill
from .model import (
    LOOKS as LOOKS,
    ArrayModel as ArrayModel,
    Kind as Kind,
    array_model as array_model,
    assembly_of as assembly_of,
    component_name as component_name,
    kind_of as kind_of,
)
from .parts import PartSet as PartSet, build_parts as build_parts, origin as origin
from .table import (
    assembly_steps as assembly_steps,
    assembly_text as assembly_text,
    write_assembly_table as write_assembly_table,
)
