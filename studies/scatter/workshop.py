"""Tolerances of a workshop by the names that a tolerance study knows them by; :mod:`acoustic_fem.scatter` has them."""

from acoustic_fem.scatter.tolerances import (
    TOLERANCES as TOLERANCES,
    ScatteredDesign as ScatteredDesign,
    Tolerance as Tolerance,
    read_tolerances as read_tolerances,
    tolerances_of as tolerances_of,
)
