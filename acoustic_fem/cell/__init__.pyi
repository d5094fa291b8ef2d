from .bent_bore import BentBore as BentBore, check_bent_bore as check_bent_bore, solve_bent_bores as solve_bent_bores
from .design_cells import is_cached as is_cached, solve_cells as solve_cells, too_large_cell as too_large_cell
from .lumped import lumped_admittance as lumped_admittance
from .one_cell import CellError as CellError, CellFault as CellFault
from .solid import Progress as Progress, checked_physics as checked_physics, port_admittance as port_admittance
