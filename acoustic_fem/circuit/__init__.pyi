from .closed_form_circuit import (
    CircuitWarning as CircuitWarning,
    SensorCircuit as SensorCircuit,
    sensor_circuit as sensor_circuit,
)
from .spice_netlist import NETLIST_FORMAT as NETLIST_FORMAT, netlist as netlist, save_netlist as save_netlist
from .state_space import (
    INPUTS as INPUTS,
    OUTPUTS as OUTPUTS,
    SensorModel as SensorModel,
    fit_sensor as fit_sensor,
)
from .state_space_file import STATE_SPACE_FORMATS as STATE_SPACE_FORMATS, save_state_space as save_state_space
from .touchstone import (
    check_ports as check_ports,
    is_touchstone as is_touchstone,
    port_impedances as port_impedances,
    save_touchstone as save_touchstone,
)
