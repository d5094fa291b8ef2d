from .journal import journal_exists as journal_exists
from .printable import worst_accepted as worst_accepted
from .problem import (
    Optimization as Optimization,
    load_optimization as load_optimization,
    read_optimization as read_optimization,
)
from .search import (
    Candidate as Candidate,
    OptimizationResult as OptimizationResult,
    found_so_far as found_so_far,
    pareto_front as pareto_front,
    ranked as ranked,
    search_designs as search_designs,
)
