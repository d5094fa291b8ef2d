"""Libraries from SOFA files of other programs: AES69-2022, conventions GeneralTF and GeneralTF-E.

Such a file states transfer functions, but neither the array nor its impedances. So it becomes a library together with
a design. Receivers are the microphones of the design. Emitters, or else measurements, are its points. Both are taken in
the order of the file, because positions in such a file may have any origin.
"""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from acoustic_fem.library.netcdf_file import LibraryError, refused_in
from acoustic_fem.library.physics import check_physics
from acoustic_fem.library.sealed_netcdf import read_netcdf
from acoustic_fem.library.sofa_file import CONVENTIONS
from acoustic_fem.library.solving import solve
from acoustic_fem.library.transfer_functions import Library, described, measured_library
from acoustic_fem.quantities.checks import frequency_grid
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design
from geometry.ground.argument_checks import check_choice, mismatch, wrong_type
from geometry.ground.refusal import Field, Kind, Refusal, counted
from geometry.ground.typed import Array, ComplexArray

#: Real and imaginary part.
_DATA = ("Data.Real", "Data.Imag")
#: Names of the unit of the frequencies.
_HERTZ = ("hertz", "hz")
#: Units of the data that are those of a transfer function; most files state none.
_RATIO = ("", "1", "pa/pa", "pascal/pascal", "pascal / pascal")
#: Texts of a file -> their names in the library's provenance. A library file must not hold SOFA's own names, because
#: they tell SOFA from netCDF.
_KEPT = {
    "Title": "title",
    "Organization": "organization",
    "AuthorContact": "author",
    "ApplicationName": "application",
    "DateCreated": "created",
    "License": "license",
}


@dataclass(frozen=True, eq=False)
class _Content:
    """Texts, arrays, dimensions and units of a file."""

    texts: dict[str, Any]
    arrays: dict[str, Any]
    dimensions: dict[str, tuple[str, ...]]
    units: dict[str, str]


def library_from_sofa(path: str | os.PathLike[str], design: DesignLike) -> Library:
    """Library of a SOFA file that another program wrote, of convention GeneralTF or GeneralTF-E.

    The data must be the pressure at a microphone per pressure in the touched cavity, Pa/Pa, with time dependence
    exp(+j omega t). Receiver k is microphone k of the design. Emitter k is point k, or measurement k is, where there is
    one emitter. The point impedance is that of the design by closed forms, and the source response is their product.

    Args:
        path: the file.
        design: the array: a design, the path of its file, or the name of a prototype.

    Returns:
        A library of fidelity "measured", without standard deviations.

    Raises:
        LibraryError: no SOFA file, damaged, one that this program wrote, or one that does not fit; names the variable.
        Refusal: a design that is not valid.
    """
    path, design = Path(path), resolve_design(design)
    content = read_netcdf(path, "a SOFA file", LibraryError, _content)
    try:
        frequency, transfer_function = _responses(content, design)
        known = solve(design, frequency, "lumped")
        texts = {own: content.texts.get(name) for name, own in _KEPT.items()}
        kept = {own: text for own, text in texts.items() if isinstance(text, str)}
        library = measured_library(
            design,
            known,
            transfer_function,
            None,
            ("numpy", "scipy", "xarray"),
            {"sofa": {"file": path.name, **kept}, "model": described(known)},
        )
        check_physics(library)
    except Refusal as error:
        raise refused_in(path, error) from None
    return library


def _content(file: Any) -> _Content:
    read = {name: one for name, one in file.variables.items() if name in ("N", *_DATA)}
    return _Content(
        dict(file.attrs),
        {name: np.asarray(one[...]) for name, one in read.items()},
        {name: tuple(one.dimensions) for name, one in read.items()},
        {name: str(one.attrs.get("Units", "")) for name, one in read.items()},
    )


def _responses(content: _Content, design: ArrayDesign) -> tuple[Array, ComplexArray]:
    """Frequencies, (n_freq,) Hz, and transfer functions, (n_point, n_microphone, n_freq) Pa/Pa."""
    texts = content.texts
    if "SOFAConventions" not in texts:
        problem = "is only allowed with a SOFA file of another program"
        raise Refusal(problem, kind=Kind.CONFLICT, field=Field("design"))
    check_choice("SOFAConventions", texts["SOFAConventions"], tuple(CONVENTIONS))
    if "DesignToml" in texts:
        raise Refusal("must not be given, because the file states its own", kind=Kind.CONFLICT, field=Field("design"))
    kind, dimensions = CONVENTIONS[texts["SOFAConventions"]]
    check_choice("DataType", texts.get("DataType"), (kind,))
    for name in ("N", *_DATA):
        if name not in content.arrays:
            raise Refusal("is missing", kind=Kind.MISSING, field=name)
    if content.units["N"].lower() not in _HERTZ:
        raise Refusal(kind=Kind.MISMATCH, field="N:Units", value=content.units["N"], allowed=("hertz",))
    try:
        frequency = frequency_grid(content.arrays["N"])
    except Refusal as error:
        raise Refusal.of(error, field="N") from None
    parts = [_part(name, content, dimensions, len(frequency)) for name in _DATA]
    if parts[0].shape != parts[1].shape:
        raise mismatch("Data.Imag", f"has shape {parts[1].shape}; it must be {parts[0].shape}, as Data.Real")
    if not parts[1].any():
        problem = "is 0 everywhere, and a response of a sensor is complex"
        raise Refusal(problem, kind=Kind.UNSUITABLE, field="Data.Imag")
    values = np.empty(parts[0].shape, np.complex128)
    values.real, values.imag = parts
    return frequency, _by_point(values, design)


def _part(name: str, content: _Content, dimensions: tuple[str, ...], many: int) -> Array:
    """One of the two parts: (measurements, receivers, frequencies, emitters) float64."""
    values, unit = content.arrays[name], content.units[name]
    if content.dimensions[name] != dimensions:
        found = ", ".join(content.dimensions[name])
        raise wrong_type(name, f"has the dimensions ({found}); they must be ({', '.join(dimensions)})")
    if values.dtype.kind != "f":
        raise wrong_type(name, f"holds {values.dtype}, not floating-point numbers")
    if unit.lower() not in _RATIO:
        raise Refusal(kind=Kind.MISMATCH, field=f"{name}:Units", value=unit, allowed=("1", "Pa/Pa"))
    if values.shape[2] != many:
        raise mismatch(name, f"has {counted(values.shape[2], 'value')} of frequency, N has {many}")
    bad = np.argwhere(~np.isfinite(values))
    if len(bad):
        where = ", ".join(f"{letter} {index + 1}" for letter, index in zip(dimensions, bad[0], strict=True))
        value = float(values[tuple(bad[0])])
        raise Refusal(f"at {where} must be finite", kind=Kind.UNSUITABLE, field=name, value=value)
    return np.asarray(values if values.ndim == 4 else values[..., None], np.float64)


def _by_point(values: ComplexArray, design: ArrayDesign) -> ComplexArray:
    """Data of a file as (n_point, n_microphone, n_freq), from (measurements, receivers, frequencies, emitters)."""
    measurements, receivers, _, emitters = values.shape
    if receivers != len(design.microphones):
        allowed = f"{counted(len(design.microphones), 'microphone')} of {design.name}"
        raise mismatch("R", f"is {counted(receivers, 'receiver')}, but must be the {allowed}")
    if measurements > 1 and emitters > 1:
        problem = f"is {counted(measurements, 'measurement')} of {counted(emitters, 'emitter')}: one of the two must be"
        raise mismatch("M", f"{problem} 1, because the other counts the points")
    letter, what = ("E", "emitter") if emitters > 1 else ("M", "measurement")
    if measurements * emitters != design.point_count:
        allowed = f"{counted(design.point_count, 'point')} of {design.name}"
        raise mismatch(letter, f"is {counted(measurements * emitters, what)}, but must be the {allowed}")
    by_point = values[0].transpose(2, 0, 1) if emitters > 1 else values[..., 0]
    return np.ascontiguousarray(by_point)
