from .coil_bore import CoilBore as CoilBore
from .leak import leak_conductance as leak_conductance
from .meshed_section import MeshedSection as MeshedSection
from .plane_wave import (
    CompliantWall as CompliantWall,
    UserLine as UserLine,
    port_admittance as port_admittance,
    tube_compliance as tube_compliance,
    two_port as two_port,
)
from .sections import (
    CircularSection as CircularSection,
    RectangularSection as RectangularSection,
    SlitSection as SlitSection,
    TriangularSection as TriangularSection,
)
from .tube_opening import (
    INERTANCE as INERTANCE,
    LARGEST_SHEAR_NUMBER as LARGEST_SHEAR_NUMBER,
    RESISTANCE as RESISTANCE,
    entrance_impedance as entrance_impedance,
)
