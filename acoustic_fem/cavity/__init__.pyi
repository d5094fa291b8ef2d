from .closed_forms import (
    bessel_zeros as bessel_zeros,
    closed_cylinder_compliance as closed_cylinder_compliance,
    closed_sphere_compliance as closed_sphere_compliance,
)
from .shaped import shaped_cavity_compliance as shaped_cavity_compliance
