from .diffusion import (
    DiffusionField as DiffusionField,
    diffusion_field as diffusion_field,
    field_coefficients as field_coefficients,
)
from .element_sizes import mesh_sizes as mesh_sizes
from .helmholtz import pressure_system as pressure_system
from .navier_stokes import WallMotion as WallMotion, cell_system as cell_system, compliance_mass as compliance_mass
