from .page import design_of as design_of, write_sweep_report as write_sweep_report
from .reporting import (
    BestDesigns as BestDesigns,
    best_designs as best_designs,
    read_results as read_results,
    save_best_design as save_best_design,
    sweep_report as sweep_report,
)
from .result_table import (
    ResultTable as ResultTable,
    table_of_search as table_of_search,
    table_of_sweep as table_of_sweep,
)
from .search_files import (
    read_search as read_search,
    save_search as save_search,
    unprintable_designs as unprintable_designs,
)
from .searching import Search as Search, optimize as optimize
