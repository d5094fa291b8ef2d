from .base_plan import plan_base as plan_base
from .bill import (
    Bill as Bill,
    BillItem as BillItem,
    Waste as Waste,
    bill_of_materials as bill_of_materials,
    write_bill as write_bill,
)
from .fit import misfits as misfits
from .model import (
    LOOKS as LOOKS,
    ArrayModel as ArrayModel,
    array_model as array_model,
    assembly_of as assembly_of,
    component_name as component_name,
)
from .order_table import (
    assembly_steps as assembly_steps,
    assembly_text as assembly_text,
    write_assembly_table as write_assembly_table,
)
from .part_list import (
    Origin as Origin,
    PartKind as PartKind,
    PartSet as PartSet,
    build_parts as build_parts,
    part_set as part_set,
)
