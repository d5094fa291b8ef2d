"""Effects of a print's tolerance on the acoustics: ratios of closed forms, from lengths alone.

In a narrow bore the flow is viscous: its resistance goes as length / radius^4 (Hagen 1839, Poiseuille 1840). The
compliance of a cavity goes as its volume. The volume compliance of a thin clamped disc goes as radius^6 / thickness^3
(Timoshenko and Woinowsky-Krieger, Theory of Plates and Shells, 1959, section 15).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from geometry.design.array_design import ArrayDesign
from geometry.ground.argument_checks import check_range

#: Usual tolerance of small printed lengths, mm: reported for every process, so that designs compare.
USUAL_TOLERANCE = 0.05


@dataclass(frozen=True)
class AcousticEffect:
    """A quantity as a printed length goes off by the tolerance, both ways; all else as designed."""

    feature: str
    """Feature that is printed too small or too large."""
    nominal: tuple[float, ...]
    """Designed lengths of the feature, mm."""
    tolerance: float
    """Amount by which a printed length may be off, mm, plus or minus."""
    quantity: str
    """Acoustic quantity that changes."""
    law: str
    """How the quantity depends on the lengths."""
    smaller: float | None
    """Relative change when every length is printed smaller by the tolerance; None where nothing is left open."""
    larger: float | None
    """Relative change when every length is printed larger by the tolerance."""


def acoustic_effects(design: ArrayDesign, tolerance: float) -> tuple[AcousticEffect, ...]:
    """Effects of a tolerance on the printed bores, cavities, chambers and membranes of a design.

    Springs and sheaths are bought: of a tube only the bore through the lips of its two ports is printed, and its
    fraction of the whole tube's resistance is given too.

    Args:
        design: the design.
        tolerance: of a printed length, mm.

    Raises:
        Refusal: a tolerance that is not above 0.
    """
    check_range("tolerance", tolerance, 0, unit="mm", excluded="low")
    lip = design.printing.port_lip
    effects = []
    for bore, length in dict.fromkeys((tube.inner_diameter, tube.length) for tube in design.tubes):
        feature, fraction = f"bore of the ports, {bore:g} mm", min(2 * lip / length, 1.0)
        effects += [
            _effect(feature, (bore,), tolerance, "resistance of the printed bore", "d^-4", _resistance),
            _effect(
                f"{feature}, tube of {length:g} mm",
                (bore,),
                tolerance,
                "resistance of the whole tube",
                f"{100 * fraction:.2g} % of its length is printed",
                partial(_resistance, fraction=fraction),
            ),
        ]
    microphone, diameter = design.microphone, design.resonator.cavity_diameter
    alike = [design.of_kind(kind) for kind in design.kinds]
    heights = dict.fromkeys(each.resonator.cavity_height for each in alike)
    thicknesses = dict.fromkeys(each.membrane.thickness for each in alike)
    chamber = (microphone.chamber_diameter, microphone.chamber_height)
    for height in heights:
        feature = "cavity" if len(heights) == 1 else f"cavity, {height:g} mm high"
        effects.append(_effect(feature, (diameter, height), tolerance, "compliance of the cavity", "d^2 h", _volume))
    effects.append(
        _effect("microphone chamber", chamber, tolerance, "compliance of the chamber", "d^2 h", _volume),
    )
    for thickness in thicknesses:
        feature = "gap of the mold" if len(thicknesses) == 1 else f"gap of the mold of {thickness:g} mm"
        effects.append(_effect(feature, (thickness,), tolerance, "compliance of the membrane", "h^-3", _stiffness))
    effects.append(_effect("rim of the cavity", (diameter,), tolerance, "compliance of the membrane", "a^6", _disc))
    return tuple(effects)


Ratio = Callable[[tuple[float, ...], tuple[float, ...]], float]


def _effect(
    feature: str, nominal: tuple[float, ...], tolerance: float, quantity: str, law: str, ratio: Ratio
) -> AcousticEffect:
    changes: list[float | None] = []
    for sign in (-1, 1):
        printed = tuple(length + sign * tolerance for length in nominal)
        changes.append(ratio(printed, nominal) - 1 if min(printed) > 0 else None)
    return AcousticEffect(feature, nominal, tolerance, quantity, law, *changes)


def _resistance(new: tuple[float, ...], old: tuple[float, ...], fraction: float = 1.0) -> float:
    return 1 - fraction + fraction * (new[0] / old[0]) ** -4


def _volume(new: tuple[float, ...], old: tuple[float, ...]) -> float:
    return (new[0] / old[0]) ** 2 * new[1] / old[1]


def _stiffness(new: tuple[float, ...], old: tuple[float, ...]) -> float:
    return (new[0] / old[0]) ** -3


def _disc(new: tuple[float, ...], old: tuple[float, ...]) -> float:
    return (new[0] / old[0]) ** 6
