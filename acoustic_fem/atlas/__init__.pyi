from .cell_in_atlas import atlas_admittance as atlas_admittance, opening_node as opening_node
from .cell_table import (
    CellAtlas as CellAtlas,
    Opening as Opening,
    OutsideAtlas as OutsideAtlas,
    cell_atlas as cell_atlas,
)
from .fidelity_choice import (
    QuickFidelity as QuickFidelity,
    outside_atlas as outside_atlas,
    quick_fidelity as quick_fidelity,
)
from .polynomial import ShapePolynomial as ShapePolynomial
