from .checks import (
    FrequencyLike as FrequencyLike,
    frequencies as frequencies,
    frequency_grid as frequency_grid,
    port_points as port_points,
)
from .fidelity import (
    FIDELITIES as FIDELITIES,
    MANY_DESIGNS as MANY_DESIGNS,
    ONE_DESIGN as ONE_DESIGN,
    Fidelity as Fidelity,
)
from .local_air import AirLike as AirLike, LocalAir as LocalAir, medium_of as medium_of
from .medium import Medium as Medium
from .units import cubic_metres as cubic_metres, metres as metres, pascals as pascals
