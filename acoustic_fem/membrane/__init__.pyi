from .disc import (
    DiscSolution as DiscSolution,
    design_compliance as design_compliance,
    design_disc as design_disc,
    disc_compliance as disc_compliance,
    solve_disc as solve_disc,
)
from .disc_table import (
    DiscTable as DiscTable,
    design_shape as design_shape,
    disc_count as disc_count,
    disc_tables as disc_tables,
    interpolated_discs as interpolated_discs,
)
from .elasticity import DiscShape as DiscShape, ElasticDisc as ElasticDisc, solve_dimensionless as solve_dimensionless
