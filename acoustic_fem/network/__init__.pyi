from .array_network import solve_network as solve_network
from .chain_matrices import TwoPort as TwoPort, join as join
from .microphone import (
    circuit_elements as circuit_elements,
    load_admittance as load_admittance,
    noise_density as noise_density,
    noise_density_behind_vent as noise_density_behind_vent,
    response as response,
    vent_ratio as vent_ratio,
)
from .microphone_output import (
    Equaliser as Equaliser,
    output_response as output_response,
)
