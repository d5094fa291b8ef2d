"""Air: density, viscosity and heat from temperature, humidity and pressure."""

from __future__ import annotations

import math
from dataclasses import dataclass

from geometry.ground.argument_checks import check_range, positive_numbers

GAS_CONSTANT = 8.314462618
MOLAR_MASS_AIR = 0.028965
MOLAR_MASS_WATER = 0.018015


@dataclass(frozen=True)
class Medium:
    """A gas at rest, treated as ideal."""

    density: float
    """Density, kg/m^3."""
    viscosity: float
    """Dynamic viscosity, Pa s."""
    conductivity: float
    """Thermal conductivity, W/(m K)."""
    heat_capacity: float
    """Heat capacity at constant pressure, J/(kg K)."""
    gamma: float
    """Ratio of heat capacities, of one."""
    pressure: float
    """Static pressure, Pa."""

    def __post_init__(self) -> None:
        for name, unit in (
            ("density", "kg/m^3"),
            ("viscosity", "Pa s"),
            ("conductivity", "W/(m K)"),
            ("heat_capacity", "J/(kg K)"),
            ("pressure", "Pa"),
        ):
            positive_numbers(name, getattr(self, name), unit)
        check_range("gamma", self.gamma, 1.0, 5 / 3)

    @property
    def sound_speed(self) -> float:
        """Adiabatic speed of sound sqrt(gamma p / rho), m/s."""
        return math.sqrt(self.gamma * self.pressure / self.density)

    @property
    def kinematic_viscosity(self) -> float:
        """Diffusivity of momentum mu / rho, m^2/s."""
        return self.viscosity / self.density

    @property
    def thermal_diffusivity(self) -> float:
        """Diffusivity of heat kappa / (rho cp), m^2/s."""
        return self.conductivity / (self.density * self.heat_capacity)

    @property
    def temperature(self) -> float:
        """Temperature of an ideal gas with these values, p / (rho cp (1 - 1 / gamma)), K; infinite at gamma = 1."""
        gas_constant = self.heat_capacity * (1 - 1 / self.gamma)
        return self.pressure / (self.density * gas_constant) if gas_constant > 0 else math.inf

    @property
    def mean_free_path(self) -> float:
        """Mean free path mu sqrt(pi / (2 p rho)), m (Kennard, Kinetic Theory of Gases, 1938, section 175)."""
        return self.viscosity * math.sqrt(math.pi / (2 * self.pressure * self.density))

    def slip_in(self, diameter: float) -> float:
        """Flow by slip over the flow without slip in a round tube: 8 mean free paths over its diameter in m.

        Kennard, section 175, with full accommodation at the wall.
        """
        return 8 * self.mean_free_path / diameter

    @classmethod
    def at(cls, temperature_c: float = 20, humidity: float = 0.5, pressure: float = 101325.0) -> Medium:
        """Humid air.

        Density and gamma are those of an ideal gas (0.05 % from the real one at 1 bar), so that
        gamma p / rho, cp and the isothermal limit V / p belong together. Dry air: viscosity and
        conductivity by E. W. Lemmon and R. T. Jacobsen, Int. J. Thermophysics 25 (2004) 21, dilute gas
        (0.1 % below the value at 1 bar); heat capacities of air and vapour, viscosity and conductivity
        of vapour by P. T. Tsilingiris, Energy Convers. Manag. 49 (2008) 1098; mixing by C. R. Wilke,
        J. Chem. Phys. 18 (1950) 517; saturation pressure by D. M. Murphy and T. Koop, Q. J. R. Meteorol.
        Soc. 131 (2005) 1539.

        Density, speed of sound, gamma and viscosity agree with table F.1 of IEC 61094-2:2009 to 0.7 %, but the thermal
        diffusivity is 2 % larger, because that standard uses an older fit of the conductivity.

        Args:
            temperature_c: -20 to 60 degC.
            humidity: relative humidity over water, 0 to 1.
            pressure: 5e4 to 1.2e5 Pa.

        Raises:
            Refusal: outside these ranges, naming the argument, its value and the range.
        """
        celsius = check_range("temperature_c", temperature_c, -20, 60, "degC")
        humidity = check_range("humidity", humidity, 0, 1)
        pressure = check_range("pressure", pressure, 5e4, 1.2e5, "Pa")
        kelvin = celsius + 273.15
        water = humidity * saturation_pressure(kelvin) / pressure

        molar_mass = (1 - water) * MOLAR_MASS_AIR + water * MOLAR_MASS_WATER
        water_by_mass = water * MOLAR_MASS_WATER / molar_mass
        dry_capacity, vapour_capacity = _dry_heat_capacity(kelvin), _vapour_heat_capacity(celsius)
        heat_capacity = (1 - water_by_mass) * dry_capacity + water_by_mass * vapour_capacity
        gas_constant = GAS_CONSTANT / molar_mass

        dry_viscosity = _dry_viscosity(kelvin)
        vapour_viscosity = (80.58131868 + 0.4000549451 * celsius) * 1e-7
        fraction = _wilke_fractions(water, dry_viscosity, vapour_viscosity)
        vapour_conductivity = (17.61758242 + 0.05558941059 * celsius + 1.663336663e-4 * celsius**2) * 1e-3
        return cls(
            density=pressure / (gas_constant * kelvin),
            viscosity=fraction[0] * dry_viscosity + fraction[1] * vapour_viscosity,
            conductivity=fraction[0] * _dry_conductivity(kelvin) + fraction[1] * vapour_conductivity,
            heat_capacity=heat_capacity,
            gamma=heat_capacity / (heat_capacity - gas_constant),
            pressure=pressure,
        )


def saturation_pressure(kelvin: float) -> float:
    """Vapour pressure of (supercooled) liquid water, Pa; Murphy and Koop (2005) eq. 10, 123 to 332 K.

    At 333 K, 1 K above its range, it is still within 0.1 % of the steam tables.
    """
    log = math.log(kelvin)
    return math.exp(
        54.842763
        - 6763.22 / kelvin
        - 4.210 * log
        + 0.000367 * kelvin
        + math.tanh(0.0415 * (kelvin - 218.8)) * (53.878 - 1331.22 / kelvin - 9.44523 * log + 0.014025 * kelvin)
    )


def _dry_viscosity(kelvin: float) -> float:
    log = math.log(kelvin / 103.3)
    collision = math.exp(0.431 - 0.4623 * log + 0.08406 * log**2 + 0.005341 * log**3 - 0.00331 * log**4)
    return 0.0266958e-6 * math.sqrt(28.9586 * kelvin) / (0.360**2 * collision)


def _dry_conductivity(kelvin: float) -> float:
    tau = 132.6312 / kelvin
    return (1.308 * _dry_viscosity(kelvin) * 1e6 + 1.405 * tau**-1.1 - 1.036 * tau**-0.3) * 1e-3


def _dry_heat_capacity(kelvin: float) -> float:
    return 1e3 * (
        1.03409 - 0.284887e-3 * kelvin + 0.7816818e-6 * kelvin**2 - 0.4970786e-9 * kelvin**3 + 0.1077024e-12 * kelvin**4
    )


def _vapour_heat_capacity(celsius: float) -> float:
    return 1e3 * (1.86910989 - 2.578421578e-4 * celsius + 1.941058941e-5 * celsius**2)


def _wilke_fractions(water: float, dry_viscosity: float, vapour_viscosity: float) -> tuple[float, float]:
    """Weights of dry air and vapour in a transport property of their mixture (Wilke 1950, eq. 14)."""

    def interaction(viscosity_ratio: float, mass_ratio: float) -> float:
        return (1 + math.sqrt(viscosity_ratio) * mass_ratio**-0.25) ** 2 / math.sqrt(8 * (1 + mass_ratio))

    mass_ratio = MOLAR_MASS_AIR / MOLAR_MASS_WATER
    ratio = dry_viscosity / vapour_viscosity
    dry = 1 - water
    return (
        dry / (dry + water * interaction(ratio, mass_ratio)),
        water / (water + dry * interaction(1 / ratio, 1 / mass_ratio)),
    )
