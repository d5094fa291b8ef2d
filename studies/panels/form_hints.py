"""Hints of a form: fields that do not count for a design, and the values that its defaults stand for."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import value_of
from geometry.design.field_values import declared_at, field_values
from geometry.schema.cavity_shapes import Box, Dome
from geometry.schema.print_processes import RULES, process_of

#: Fields that count only if another field of the same table has one of some values, with that field and these values.
_ONLY_WITH: Mapping[str, tuple[str, tuple[Any, ...]]] = {
    **dict.fromkeys(
        ("resonator.box_length", "resonator.box_width", "resonator.corner_radius", "resonator.collar_height"),
        ("resonator.shape", ("box",)),
    ),
    "resonator.dome_depth": ("resonator.shape", ("dome",)),
    "membrane.rim_height": ("membrane.shape", ("rim",)),
    "membrane.boss_diameter": ("membrane.shape", ("boss",)),
    "membrane.boss_height": ("membrane.shape", ("boss",)),
    "shell.label_height": ("shell.label", ("raised", "engraved")),
    "shell.label_relief": ("shell.label", ("raised", "engraved")),
    "layout.diameter": ("layout.kind", ("cylinder",)),
    "layout.palm": ("layout.kind", ("hand",)),
    "layout.spread": ("layout.kind", ("hand",)),
    "layout.places": ("layout.kind", ("places",)),
    "layout.columns": ("layout.kind", ("serpentine", "area", "cylinder", "hand")),
    "layout.depth": ("layout.microphone_side", ("below",)),
    "printing.carrier_gap": ("printing.carrier", ("row", "sheet")),
    "printing.carrier_neck": ("printing.carrier", ("row", "sheet")),
}
#: Fields that count only if another one is given and not zero.
_ONLY_GIVEN = {
    "resonator.leak_length": "resonator.leak_diameter",
    "shell.groove_depth": "shell.groove_width",
    "shell.foot_length": "shell.feet",
    "shell.foot_hole": "shell.feet",
    "membrane.expansion_mismatch": "membrane.gluing_temperature",
    "membrane.glue_material": "membrane.glue_thickness",
    "microphone.gasket_depth": "microphone.gasket_width",
    "mold.shim_step": "mold.shim_count",
}


def fields_without_effect(design: ArrayDesign) -> list[str]:
    """Dotted names of the fields that do not count for a design as it is, and are not given either.

    A field that is given differently from its default is never among them, so that nothing of a file is hidden.
    """
    known = field_values(design)
    found = [
        name for name, (other, values) in _ONLY_WITH.items() if name in known and value_of(design, other) not in values
    ]
    found += [name for name, other in _ONLY_GIVEN.items() if name in known and not value_of(design, other)]
    return [name for name in found if known[name] == declared_at(name).default]


def values_in_use(design: ArrayDesign) -> dict[str, float | str]:
    """Values that stand where a design gives none, by the dotted names of their fields, in their units."""
    known, process = field_values(design), process_of(design.printing)
    found: dict[str, float | str] = {
        "resonator.port_height": design.resonator.port_axis_height,
        "resonator.floor_material": "rigid",
        "layout.pitch": max(design.pitch_of(line) for line in design.lines),
        "membrane.gluing_temperature": design.air.temperature,
        "membrane.glue_material": design.membrane.material,
        "microphone.board_length": design.microphone.board_size[0],
        "microphone.board_width": design.microphone.board_size[1],
        "tube.bend_radius": design.tube.smallest_bend_radius,
        "tube.sheath_material": "rigid",
        "microphone_tube.bend_radius": design.microphone_tube.smallest_bend_radius,
        "microphone_tube.sheath_material": "rigid",
        **{f"printing.rules.{name}": getattr(process, name).limit for name in RULES},
        **{f"printing.rules.{name}_advised": getattr(process, name).advised for name in RULES},
        **{f"printing.rules.{name}": getattr(process, name) for name in ("pixel", "tolerance")},
        **dict.fromkeys(("target.size", "target.budget"), "no limit"),
        **dict.fromkeys(("shell.groove_width", "microphone.gasket_width"), "none"),
    }
    shape = design.resonator.cavity_shape
    if isinstance(shape, Box):
        found |= {
            "resonator.box_length": shape.length,
            "resonator.box_width": shape.width,
            "resonator.corner_radius": shape.corner_radius,
            "resonator.collar_height": shape.collar_height,
        }
    if isinstance(shape, Dome):
        found["resonator.dome_depth"] = shape.depth
    return {
        name: float(f"{value:.6g}") if isinstance(value, float) else value
        for name, value in found.items()
        if name in known and known[name] is None and value != math.inf
    }
