from .chain import cell_lines as cell_lines, check_points as check_points, run_design as run_design
from .check import DesignCheck as DesignCheck, check_design as check_design
from .findings import verdict as verdict
from .part_folder import MadeParts as MadeParts, make_parts as make_parts
from .wiring import draw_wirings as draw_wirings, wirings as wirings
