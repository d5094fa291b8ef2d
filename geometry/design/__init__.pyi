from .array_design import ArrayDesign as ArrayDesign
from .design_file import (
    prototype as prototype,
    prototype_names as prototype_names,
    prototype_text as prototype_text,
    read_design as read_design,
    resolve_design as resolve_design,
    value_of as value_of,
    write_design as write_design,
)
from .places_file import save_places as save_places
from .shell_rules import (
    FOOT_EDGE as FOOT_EDGE,
    cavity_problems as cavity_problems,
    feature_problems as feature_problems,
    ledge_height as ledge_height,
)
