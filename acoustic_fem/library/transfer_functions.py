"""Transfer functions of a whole array: ``solve`` and its labelled result."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence, Sized
from dataclasses import asdict, astuple, dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr
from numpy.typing import NDArray

import acoustic_fem
from acoustic_fem.library.other_air import air_ratio
from acoustic_fem.library.provenance import library_provenance
from acoustic_fem.library.response_plot import Quantity, plot_responses
from acoustic_fem.library.touch_pressure import touch_flow, touch_response
from acoustic_fem.quantities.local_air import AirLike, LocalAir, checked_air, design_air, medium_of
from acoustic_fem.quantities.medium import Medium
from geometry.design.array_design import ArrayDesign
from geometry.ground.late import function_above
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.shown import Shown
from geometry.ground.typed import Array, ComplexArray
from geometry.layout.placement import point_places

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Fidelity of a library made from recordings (:mod:`acoustic_fem.calibration`).
MEASURED = "measured"

#: Name -> dimensions, units and description of the results.
VARIABLES = {
    "transfer_function": (
        ("point", "microphone", "frequency"),
        "Pa/Pa",
        "pressure at the microphone per pressure in the touched cavity",
    ),
    "source_response": (
        ("point", "microphone", "frequency"),
        "Pa s/m^3",
        "pressure at the microphone per volume velocity injected at the membrane of the point",
    ),
    "point_impedance": (
        ("point", "frequency"),
        "Pa s/m^3",
        "pressure in the cavity per volume velocity injected at its membrane",
    ),
    "microphone_impedance": (
        ("microphone", "microphone_2", "frequency"),
        "Pa s/m^3",
        "pressure at the microphone per volume velocity injected at the front of the second microphone",
    ),
}

#: Attributes of the response per newton, which follows from the source response and the design.
FORCE_RESPONSE = {
    "units": "Pa/N",
    "long_name": "pressure at the microphone per force on the middle quarter of the membrane's radius",
}

#: Real, unlike the others: what is known of the errors of measured transfer functions.
DEVIATION = (
    ("point", "microphone", "frequency"),
    "Pa/Pa",
    "standard deviation of the real part, and of the imaginary part, of the transfer function",
)

#: Those of them that older files and measured libraries may lack.
OPTIONAL = frozenset({"microphone_impedance"})


@dataclass(frozen=True, eq=False, repr=False)
class Library(Shown):
    """Responses of one array at a grid of frequencies, with everything needed to make them again.

    The volume velocity is injected in parallel with the membrane's own compliance, which stays part of
    the array: a touch that would sweep the volume q of a membrane in vacuo injects j w q.
    """

    transfer_function: xr.DataArray
    """Microphone pressure per pressure in the touched cavity, (point, microphone, frequency) complex128, Pa/Pa.
    Microphone pressure: on the diaphragm, behind the sound hole.
    """
    source_response: xr.DataArray
    """Microphone pressure per injected volume velocity, (point, microphone, frequency) complex128, Pa s/m^3."""
    point_impedance: xr.DataArray
    """Cavity pressure per injected volume velocity, (point, frequency) complex128, Pa s/m^3."""
    design: ArrayDesign
    """The array."""
    fidelity: str
    """How the cells were computed, one of :data:`acoustic_fem.FIDELITIES`, or :data:`MEASURED`."""
    medium: Medium
    """The air."""
    provenance: Mapping[str, Any]
    """Code and library versions, creation time, seed, hash of the frequency grid, and how each distinct cell was
    solved.
    """
    microphone_impedance: xr.DataArray | None = None
    """Pressure at a microphone per volume velocity injected at the front of another, (microphone, microphone_2,
    frequency) complex128, Pa s/m^3, the microphones' own load included: what thermal noise needs. None in files of
    older versions and in measured libraries.
    """
    transfer_function_deviation: xr.DataArray | None = None
    """One standard deviation of the real part and of the imaginary part of the transfer function, (point, microphone,
    frequency) float64, Pa/Pa. None where it was computed.
    """

    @property
    def frequency(self) -> Array:
        """Grid of frequencies, (n_freq,) float64, ascending, Hz."""
        return np.asarray(self.transfer_function["frequency"].values)

    @property
    def force_response(self) -> xr.DataArray:
        """Microphone pressure per force on the membrane, (point, microphone, frequency) complex128, Pa/N.

        The force is spread over a patch of a quarter of the opening's radius in the middle of the membrane and
        pushes inwards; it injects j w V(w) per newton, V from the elastic solution of the design's membrane.
        Other patches, and responses per displacement and per outside pressure: :meth:`touch_response`.
        """
        return self.touch_response("force").rename("force_response").assign_attrs(FORCE_RESPONSE)

    @property
    def cavity_response(self) -> xr.DataArray:
        """Pressure in the touched cavity per force on its membrane, (point, frequency) complex128, Pa/N.

        The force is that of :attr:`force_response`, which is the product of this response and the transfer function.
        """
        impedance = self.point_impedance.transpose("point", "frequency")
        return (
            impedance.copy(data=impedance.values * touch_flow(self.design, impedance, "force"))
            .assign_attrs({"units": "Pa/N", "long_name": "pressure in the cavity per force on its membrane"})
            .rename("cavity_response")
        )

    def touch_response(self, touch: str, *, contact_radius: float | None = None) -> xr.DataArray:
        """Pressure at the microphones per touch of each membrane.

        Args:
            touch: "displacement" (m), "force" (N) or "pressure" (Pa).
            contact_radius: of the patch that is touched, m; by default a quarter of the opening's radius.

        Returns:
            (point, microphone, frequency) complex128, Pa per unit of the touch.

        Raises:
            Refusal: an unknown touch, or a contact radius out of range.
        """
        return touch_response(
            self.design, self.source_response, self.point_impedance, touch, contact_radius=contact_radius
        )

    @property
    def acceleration_response(self) -> xr.DataArray:
        """Microphone pressure per acceleration of the sensor, (microphone, axis, frequency) complex128, Pa s2/m.

        The inertia of all membranes adds, see :func:`acoustic_fem.library.acceleration.acceleration_response`.
        """
        found: xr.DataArray = function_above("acoustic_fem.library.acceleration", "acceleration_response")(self)
        return found

    def simulate(
        self,
        force: Any,
        rate: float,
        *,
        touch: str = "force",
        output: str = "pressure",
        tolerance: float | None = None,
    ) -> Array:
        """Signals of the microphones while membranes are pressed, at any rate and of any length.

        A sum of poles is fitted to the responses from 1 mHz to the end of the library, and stepped exactly from sample
        to sample (:mod:`acoustic_fem.circuit.force_simulation`). So presses that are held, leaks and rubber that creeps
        come out right. Noise and large presses are left out: :mod:`localize.contacts` has them.

        The signals are wrong for frequencies of the force above the last frequency of the library, because nothing was
        fitted there. If that part of the force peaks above 1 % of the largest force, a ``ModelLimitWarning`` says how
        much it is. Then solve the library to a higher frequency, or let the force rise and fall more slowly.

        Args:
            force: (n_point, n_sample) real numbers, N, or m^3/s for a volume velocity; straight from sample to sample,
                and 0 before the first.
            rate: samples per second, Hz.
            touch: "force" on the patch of :attr:`force_response`, or "volume-velocity" at the membrane.
            output: "pressure" in front of each microphone, Pa, or its "voltage", V.
            tolerance: largest error of the fit, relative to the magnitude of each response at each frequency, 1e-6 to
                0.1. By default 3e-4. For a measured library that has standard deviations it is the largest error that
                they make probable.

        Returns:
            (n_microphone, n_sample) float64.

        Raises:
            Refusal: forces of another shape or that are not finite, an unknown touch or output, a rate or tolerance out
                of range, or a library of fewer than 12 frequencies.
            VectorFitError: no sum of up to 60 poles keeps the tolerance; the message has the error that one reaches.
        """
        found: Array = function_above("acoustic_fem.circuit.force_simulation", "simulate")(
            self, force, rate, touch=touch, output=output, tolerance=tolerance
        )
        return found

    def shown(self) -> tuple[str, Mapping[str, object]]:
        """Title and facts that a session and a notebook show."""
        points, microphones, count = self.transfer_function.transpose("point", "microphone", "frequency").shape
        measured = self.transfer_function_deviation is not None
        return f"Library of {self.design.name}", {
            "transfer functions": f"{points} points, {microphones} microphones, {count} frequencies, Pa/Pa",
            "frequency": f"{self.frequency[0]:g} to {self.frequency[-1]:g} Hz",
            "fidelity": self.fidelity,
            "air": f"{self.medium.pressure:g} Pa, density {self.medium.density:.4g} kg/m^3",
            "standard deviation": "of each transfer function" if measured else "",
            "membranes": self.provenance.get("membranes", ""),
            "made by": f"acoustic-fem {self.provenance.get('code_version', '')}",
        }

    def plot(self, quantity: Quantity = "level", microphones: Sequence[str] | None = None) -> Figure:
        """Figure with a panel for each microphone, or each pair of them, and a curve for each point.

        Args:
            quantity: "level" or "phase" of the transfer functions, or "ild" or "ipd", their level or phase difference
                between two microphones.
            microphones: names of those that are shown; by default all.

        Raises:
            Refusal: an unknown quantity or microphone, or a difference of one microphone.
            MissingExtra: matplotlib is not installed.
        """
        return plot_responses(self.transfer_function, quantity, microphones)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the library in the format of the name's suffix; missing folders are made.

        Args:
            path: a name that ends with ``.nc``, ``.sofa``, ``.npz`` or ``.csv``.

        Raises:
            LibraryError: another suffix, a file that cannot be written, or one that is there and is not a library, or
                a measured one.
        """
        function_above("acoustic_fem.library.exchange", "export")(self, path, folders=True)

    def in_air(
        self,
        air: LocalAir | None = None,
        *,
        pressure: float | None = None,
        temperature_c: float | None = None,
        humidity: float | None = None,
        altitude: float | None = None,
        overpressure: float | None = None,
        hours: float | None = None,
    ) -> Library:
        """The same sensor at another place, without a new 3-D solve.

        All responses are multiplied by the change that the closed forms predict (:func:`air_ratio`), in measured
        libraries too. For array-2x6, 1 to 200 Hz, that is within 0.23 % of a new 3-D solve at 2000 m,
        where the air changes the far microphone by 63 %, within 0.05 % at 10 K more, and within 0.4 % at 60 kPa and
        0 degC. The rubber stays as it was: its change with temperature is not part of the air.

        By default the enclosed air has had the time to come to the pressure outside, through the silicone or a leak. If
        you give ``hours``, the sensor was closed or left to rest in the air of its design, and its enclosed air bulges
        and stiffens the membranes (:func:`acoustic_fem.enclosed.enclosed_air`).

        Args:
            air: of the place; in place of all other arguments.
            pressure: static pressure there, not reduced to sea level, 5e4 to 1.2e5 Pa.
            temperature_c: temperature, -20 to 60 degC.
            humidity: relative, 0 to 1.
            altitude: in place of the pressure, m above the sea: that of the standard atmosphere.
            overpressure: static pressure of the enclosed air above that outside, -2e4 to 2e4 Pa.
            hours: in place of the overpressure, time since the sensor came into this air, h, from 0.

        Returns:
            A library with the new air in its design and medium. Values that you do not give stay. If nothing changes,
            the library itself is returned.

        Raises:
            Refusal: a value out of range, pressure and altitude or overpressure and hours at once, an air beside values
                of its own, membranes whose bulge is not known, or a library of other air than its design's.
        """
        checked_air(air)
        stated = LocalAir(pressure, altitude, temperature_c, humidity, overpressure)
        if air is not None and stated.design_values:
            raise Refusal("must not be given beside values of its own", kind=Kind.CONFLICT, field="air")
        values = (air or stated).design_values
        if hours is not None:
            if "air.overpressure" in values:
                raise Refusal("must not be given beside an overpressure", kind=Kind.CONFLICT, field="hours")
            enclosed = acoustic_fem.enclosed.enclosed_air(self.design, air or stated, hours=hours)
            values = {**values, "air.overpressure": enclosed.overpressure}
        if not values:
            return self
        design = self.design.with_values(values)
        medium, before = design_air(design), design_air(self.design)
        if not np.allclose(astuple(self.medium), astuple(before), rtol=1e-6):
            raise Refusal(
                f"of the library of {self.design.name} (pressure {self.medium.pressure:g} Pa, viscosity "
                f"{self.medium.viscosity:g} Pa s) is not the air of its design, so its other air is not known",
                kind=Kind.CONFLICT,
                field="medium",
            )
        if design.air == self.design.air:
            return self
        ratio = air_ratio(self.design, design, self.frequency)
        deviation = self.transfer_function_deviation
        stored = {name: getattr(self, name) for name in VARIABLES}
        return library_from_arrays(
            design,
            self.frequency,
            {
                name: array.transpose(*VARIABLES[name][0]).values * ratio[name]
                for name, array in stored.items()
                if array is not None
            },
            self.fidelity,
            medium,
            {**self.provenance, "brought_from_air": asdict(self.medium)},
            None
            if deviation is None
            else deviation.transpose(*DEVIATION[0]).values * np.abs(ratio["transfer_function"]),
        )


def library_from_arrays(
    design: ArrayDesign,
    frequency: Array,
    values: Mapping[str, ComplexArray],
    fidelity: str,
    air: AirLike,
    provenance: Mapping[str, Any],
    deviation: Array | None = None,
) -> Library:
    """A library from bare arrays.

    Args:
        design: the array.
        frequency: (n_freq,) float64, ascending, Hz.
        values: complex128 arrays by the names of :data:`VARIABLES`, of the dimensions, such as (point, microphone,
            frequency), and in the units that are listed there; those of :data:`OPTIONAL` may be missing.
        fidelity: how the cells were computed, one of :data:`acoustic_fem.FIDELITIES`, or :data:`MEASURED`.
        air: a :class:`acoustic_fem.LocalAir`, or a gas of its own.
        provenance: what made the values.
        deviation: (n_point, n_microphone, n_freq) float64, Pa/Pa, that of the transfer function, where it was measured.
    """
    medium = medium_of(air)
    rows: dict[str, NDArray[Any]] = {name: values[name] for name in VARIABLES if name in values or name not in OPTIONAL}
    if deviation is not None:
        rows["transfer_function_deviation"] = deviation
    grid = np.asarray(frequency, dtype=np.float64).tobytes()
    labels = _labels(point_places(design), design.microphones, grid, tuple(rows))
    dataset = labels.copy(deep=True, data=rows)
    arrays = {name: dataset[name] for name in rows}
    return Library(**arrays, design=design, fidelity=fidelity, medium=medium, provenance=dict(provenance))


@lru_cache(maxsize=4)  # coordinates and attributes of xarray cost more than a network of twelve points
def _labels(
    points: tuple[tuple[int, int], ...], microphones: tuple[str, ...], grid: bytes, names: tuple[str, ...]
) -> xr.Dataset:
    """Variables of a library with their coordinates and attributes and without their values.

    Args:
        points: line and place of each.
        microphones: names.
        grid: frequencies, Hz, as bytes of float64.
        names: of the variables.
    """
    frequency = np.frombuffer(grid)
    lines, places = zip(*points, strict=True)
    coordinates: dict[str, tuple[str, Sized, dict[str, str]]] = {
        "point": ("point", list(range(1, len(lines) + 1)), {"long_name": "sensing point, from 1"}),
        "line": ("point", list(lines), {"long_name": "index of its line, from 0"}),
        "place": ("point", list(places), {"long_name": "index along its line, from 0"}),
        "microphone": ("microphone", list(microphones), {"long_name": "microphone"}),
        "microphone_2": ("microphone_2", list(microphones), {"long_name": "second microphone"}),
        "frequency": ("frequency", frequency, {"units": "Hz", "long_name": "frequency"}),
    }
    sizes = {name: len(values) for name, (dimension, values, _) in coordinates.items() if name == dimension}
    described = {**VARIABLES, "transfer_function_deviation": DEVIATION}
    variables = {}
    for name in names:
        dimensions, units, description = described[name]
        empty = np.broadcast_to(0.0, [sizes[dimension] for dimension in dimensions])
        variables[name] = (dimensions, empty, {"units": units, "long_name": description})
    return xr.Dataset(variables, coords=coordinates)


def measured_library(
    design: ArrayDesign,
    known: Library,
    transfer_function: ComplexArray,
    deviation: Array | None,
    libraries: Sequence[str],
    provenance: Mapping[str, Any],
) -> Library:
    """Library of a made sensor: its transfer functions as measured, the rest from the library known before.

    Impedances are not measured: the point impedance stays, and the source response is that times the transfer function.

    Args:
        design: of the sensor.
        known: library of that design, or of one with the same points and microphones, on the same frequencies.
        transfer_function: (n_point, n_microphone, n_freq) Pa/Pa.
        deviation: (n_point, n_microphone, n_freq) one standard deviation of the real part, and of the imaginary part,
            of the transfer function, Pa/Pa; None where it is not known.
        libraries: distributions whose versions matter.
        provenance: what it was measured from, as JSON can hold it.
    """
    impedance = known.point_impedance.transpose("point", "frequency").values
    return library_from_arrays(
        design,
        known.frequency,
        {
            "transfer_function": transfer_function,
            "source_response": transfer_function * impedance[:, None],
            "point_impedance": impedance,
        },
        MEASURED,
        known.medium,
        {**library_provenance(known.frequency, libraries), **provenance},
        deviation,
    )


def described(library: Library) -> dict[str, Any]:
    """Provenance of a library and how its cells were computed, for that of another which is made from it."""
    return {"fidelity": library.fidelity, **library.provenance}
