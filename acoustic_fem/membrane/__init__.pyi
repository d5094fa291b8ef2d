from .bulged import BulgeLaw as BulgeLaw
from .design_discs import (
    design_bulge as design_bulge,
    design_bulge_ratio as design_bulge_ratio,
    design_compliance as design_compliance,
    design_disc as design_disc,
    design_mounting as design_mounting,
    design_mounting_ratio as design_mounting_ratio,
    design_rubber as design_rubber,
    design_shape as design_shape,
    design_stiffening as design_stiffening,
)
from .disc import (
    DiscOptions as DiscOptions,
    DiscSolution as DiscSolution,
    KnownDiscs as KnownDiscs,
    disc_compliance as disc_compliance,
    solve_disc as solve_disc,
)
from .disc_table import (
    DiscTable as DiscTable,
    DiscTables as DiscTables,
    disc_count as disc_count,
    disc_tables as disc_tables,
)
from .elasticity import ElasticDisc as ElasticDisc, solve_dimensionless as solve_dimensionless
from .half_section import DiscShape as DiscShape, Mounting as Mounting
from .large_deflection import (
    BulgeResponse as BulgeResponse,
    FlatPunch as FlatPunch,
    Indenter as Indenter,
    MountedMembrane as MountedMembrane,
    PressCurve as PressCurve,
    PressResponse as PressResponse,
    SoftPatch as SoftPatch,
    Sphere as Sphere,
    bulge as bulge,
    design_membrane as design_membrane,
    press as press,
    press_curve as press_curve,
)
from .mounting import mounting_ratio as mounting_ratio
from .pressing_limits import PressLimits as PressLimits, press_limits as press_limits
from .rubber import (
    ELASTIC as ELASTIC,
    Rubber as Rubber,
    causal_slope as causal_slope,
    modulus_ratio as modulus_ratio,
)
from .spheres_of_any_radius import SpherePresses as SpherePresses
