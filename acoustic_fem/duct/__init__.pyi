from .meshed_section import MeshedSection as MeshedSection
from .opening import (
    INERTANCE as INERTANCE,
    LARGEST_SHEAR_NUMBER as LARGEST_SHEAR_NUMBER,
    RESISTANCE as RESISTANCE,
    entrance_impedance as entrance_impedance,
)
from .plane_wave import port_admittance as port_admittance
