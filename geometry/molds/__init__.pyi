from .mold import (
    Mold as Mold,
    MoldKind as MoldKind,
    build_mold as build_mold,
    mold_counts as mold_counts,
    mold_kinds as mold_kinds,
    molds_of as molds_of,
)
from .mold_plan import plan_mold as plan_mold
