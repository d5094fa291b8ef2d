from .mold import Mold as Mold, build_mold as build_mold, mold_counts as mold_counts
from .plan import plan_mold as plan_mold
