from .checks import (
    frequency_grid as frequency_grid,
    in_range as in_range,
    numbers as numbers,
    port_points as port_points,
    positive as positive,
    stated_grid as stated_grid,
)
from .fidelity import FIDELITIES as FIDELITIES, Fidelity as Fidelity
from .medium import Medium as Medium
from .units import cubic_metres as cubic_metres, metres as metres, pascals as pascals
