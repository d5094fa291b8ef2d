from .body_fit import fit_design as fit_design
from .check import DesignCheck as DesignCheck, check_design as check_design
from .enclosed_air import EnclosedChange as EnclosedChange, EnclosedFindings as EnclosedFindings
from .file_list import FolderCheck as FolderCheck, verify_run as verify_run
from .findings import accuracy_rows as accuracy_rows, summary as summary
from .library_files import cell_lines as cell_lines, convert_library as convert_library, solve_library as solve_library
from .pipeline import run_design as run_design
from .quality import DesignQuality as DesignQuality, design_quality as design_quality, draw_quality as draw_quality
from .shaking import ShakenFindings as ShakenFindings, ShakenState as ShakenState
from .starting import copy_prototype as copy_prototype
from .stock_listing import StockListing as StockListing, list_stock as list_stock
from .wiring import draw_wirings as draw_wirings, wiring_table as wiring_table, wirings as wirings
from .worst_findings import (
    folded_sections as folded_sections,
    worst_assumption as worst_assumption,
    worst_of_air as worst_of_air,
    worst_of_motion as worst_of_motion,
    worst_of_printing as worst_of_printing,
    worst_of_stock as worst_of_stock,
)
