from .array_fields import StatedArray as StatedArray
from .cavity_shapes import (
    WIDEST_BOX as WIDEST_BOX,
    Box as Box,
    Dome as Dome,
    draw_cavity as draw_cavity,
    separation as separation,
    wall_distance as wall_distance,
)
from .declared_fields import DesignField as DesignField, field_named as field_named, fields_of as fields_of
from .field_errors import (
    DERIVED_FROM as DERIVED_FROM,
    DesignError as DesignError,
    UnknownField as UnknownField,
    check_value as check_value,
    error_from_validation as error_from_validation,
    model_of as model_of,
    nearest as nearest,
)
from .manufacture import Molding as Molding, Printing as Printing
from .materials import MATERIALS as MATERIALS
from .part_fields import (
    BOARD_SEAL as BOARD_SEAL,
    SEAT_SLOT as SEAT_SLOT,
    SOCKET_COVER as SOCKET_COVER,
    Membrane as Membrane,
    Microphone as Microphone,
    Resonator as Resonator,
    Shell as Shell,
    Tube as Tube,
)
from .ports import (
    ANGLE_STEP as ANGLE_STEP,
    CellPort as CellPort,
    Port as Port,
    foot_directions as foot_directions,
    in_common_rotation as in_common_rotation,
    largest_gap as largest_gap,
    port_rank as port_rank,
    port_web as port_web,
)
from .print_processes import (
    CAST_THICKNESS as CAST_THICKNESS,
    NUMBERS as NUMBERS,
    RULES as RULES,
    PrintProcess as PrintProcess,
    Relation as Relation,
    Rule as Rule,
    Verdict as Verdict,
    find_process as find_process,
    process_of as process_of,
)
from .target import Target as Target
