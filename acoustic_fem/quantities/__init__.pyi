from .checks import (
    frequency_grid as frequency_grid,
    in_range as in_range,
    numbers as numbers,
    one_of as one_of,
    port_points as port_points,
    positive as positive,
)
from .fidelity import (
    FIDELITIES as FIDELITIES,
    MANY_DESIGNS as MANY_DESIGNS,
    ONE_DESIGN as ONE_DESIGN,
    Fidelity as Fidelity,
)
from .local_air import LocalAir as LocalAir
from .medium import Medium as Medium
from .units import cubic_metres as cubic_metres, metres as metres, pascals as pascals
