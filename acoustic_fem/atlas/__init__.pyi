from .cell_in_atlas import atlas_admittance as atlas_admittance, opening_node as opening_node
from .polynomial import ShapePolynomial as ShapePolynomial
from .quick import QuickFidelity as QuickFidelity, quick_fidelity as quick_fidelity
from .table import CellAtlas as CellAtlas, Opening as Opening, OutsideAtlas as OutsideAtlas, cell_atlas as cell_atlas
