"""Rules between the fields of a design: combinations that cannot be built are refused by name."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import partial

from geometry.design import shell_rules
from geometry.design.base_rules import base_rules
from geometry.design.frozen_rules import length_rules, surface_rules
from geometry.design.kind_rules import kind_rules, pattern_rules
from geometry.design.layout_rules import area_rules, cylinder_rules, hand_rules, plane_rules
from geometry.design.place_rules import places_rules, side_rules
from geometry.design.tube_rules import microphone_socket_rules, socket_rules, tube_rules
from geometry.ground.refusal import Kind, Refusal
from geometry.schema.array_fields import StatedArray
from geometry.schema.field_errors import conflict
from geometry.schema.materials import MATERIALS
from geometry.schema.part_fields import SOCKET_COVER
from geometry.schema.print_processes import process_of

#: Most that the depth of a cavity is corrected by, as a part of the thickness: more is no print error.
_MOST_TRIM = 0.5
#: Most by which shims raise the lid of a mold, mm: the pins stay in their sockets.
MOST_SHIMS = 1.0


def check_consistency(design: StatedArray) -> None:
    """Refuse a design whose fields, each allowed alone, do not go together.

    Raises:
        Refusal: the first broken rule, with field, value and what is allowed.
    """
    of_points = (
        _membrane,
        _membrane_shape,
        _mold,
        tube_rules,
        socket_rules,
        shell_rules.cavity_shape,
        shell_rules.shell_features,
    )
    for rule in (
        pattern_rules,
        length_rules,
        surface_rules,
        _materials,
        _soft_parts,
        *of_points,
        partial(kind_rules, rules=of_points),
        _sound_hole,
        _board,
        plane_rules,
        area_rules,
        cylinder_rules,
        hand_rules,
        places_rules,
        side_rules,
        microphone_socket_rules,
        _print_rules,
        base_rules,
    ):
        for problem in rule(design):
            try:
                raise problem
            finally:
                del problem  # else its traceback holds this frame, which holds it: a circle for the garbage collector


def _materials(design: StatedArray) -> Iterator[Refusal]:
    for field, name in design.materials_in_use():
        if name not in design.materials and name not in MATERIALS:
            yield Refusal(kind=Kind.UNKNOWN, field=field, value=name, allowed=sorted({*MATERIALS, *design.materials}))


def _soft_parts(design: StatedArray) -> Iterator[Refusal]:
    """Proportions of what yields beside the membranes."""
    floor, diameter = design.resonator.floor_thickness, design.resonator.cavity_diameter
    if design.resonator.floor_material is not None and not 0.005 * diameter <= floor <= diameter:
        yield conflict(
            "resonator.floor_thickness",
            floor,
            (
                f"between {0.005 * diameter:g} and {diameter:g} mm for resonator.floor_material: a floor that yields is"
                " 0.01 to 2 radii of the cavity thick"
            ),
        )
    for field, tube, _ in design.stated_tubes():
        if tube.sheath_material is not None and tube.sheath_wall <= 1e-9:
            yield conflict(
                f"{field}.outer_diameter",
                tube.outer_diameter,
                f"above {tube.spring_outer_diameter:g} mm, the outside of the spring, for {field}.sheath_material",
            )


def _membrane(design: StatedArray) -> Iterator[Refusal]:
    """Membranes that the shell holds, of proportions that ``acoustic_fem.membrane.disc.solve_disc`` covers.

    Its widest rim, 50 radii, is beyond every rim and cavity that the fields allow.
    """
    radius, thickness = design.resonator.cavity_diameter / 2, design.membrane.thickness
    cavity = f"of resonator.cavity_diameter ({2 * radius:g} mm)"
    if thickness < 0.01 * radius:
        yield conflict("membrane.thickness", thickness, f"at least {0.01 * radius:g} mm, 0.01 radii {cavity}")
    mounted, stretch = design.membrane.mounted_thickness, design.membrane.stretch
    if mounted < 0.01 * radius * (1 - 1e-9) <= thickness:
        yield conflict(
            "membrane.stretch",
            stretch,
            (
                f"at most {math.sqrt(thickness / (0.01 * radius)):g}, where membrane.thickness ({thickness:g} mm) is "
                f"thinned to {0.01 * radius:g} mm, 0.01 radii {cavity}"
            ),
            unit="",
        )
    if thickness > 2 * radius:
        yield conflict("membrane.thickness", thickness, f"at most {2 * radius:g} mm, 2 radii {cavity}")
    rim, wall = design.membrane.rim_width, design.resonator.wall_thickness
    if rim < 0.05 * thickness:
        yield conflict(
            "membrane.rim_width",
            rim,
            f"at least {0.05 * thickness:g} mm, a twentieth of membrane.thickness ({thickness:g} mm)",
        )
    if rim > wall:
        yield conflict("membrane.rim_width", rim, f"at most resonator.wall_thickness ({wall:g} mm)")


def _membrane_shape(design: StatedArray) -> Iterator[Refusal]:
    """A rim or a boss stands on the outer face of the disc; each has its own fields."""
    membrane, cavity = design.membrane, design.resonator.cavity_diameter
    for shape, names in (("rim", ("rim_height",)), ("boss", ("boss_diameter", "boss_height"))):
        for name in names:
            value = getattr(membrane, name)
            if membrane.shape == shape and value is None:
                allowed = f"given in mm for membrane.shape = {shape!r}"
                yield Refusal(kind=Kind.MISSING, field=f"membrane.{name}", allowed=allowed)
            elif membrane.shape != shape and value is not None:
                problem = f"goes with membrane.shape = {shape!r}, not {membrane.shape!r}"
                yield conflict(f"membrane.{name}", value, problem=problem)
    if membrane.shape != "flat" and membrane.stretch != 1:
        yield conflict(
            "membrane.stretch",
            membrane.stretch,
            f"1 for membrane.shape = {membrane.shape!r}: only a flat disc is stretched evenly",
            unit="",
        )
    if membrane.shape != "flat" or membrane.stretch != 1:
        other = "shape" if membrane.shape != "flat" else "stretch"
        for name, fits in (("prestrain", 0.0), ("gluing_temperature", None), ("glue_thickness", 0.0)):
            if getattr(membrane, name) != fits:
                problem = f"needs a flat disc that is not stretched; membrane.{other} is {getattr(membrane, other)}"
                yield conflict(f"membrane.{name}", getattr(membrane, name), problem=problem, unit="")
    if membrane.glue_thickness and membrane.mounting == "clamped":
        problem = "goes with membrane.mounting = 'rim': the rim of a clamped disc cannot move"
        yield conflict("membrane.glue_thickness", membrane.glue_thickness, problem=problem)
    if membrane.total_height - membrane.thickness > cavity:
        name = "rim_height" if membrane.shape == "rim" else "boss_height"
        yield conflict(
            f"membrane.{name}",
            membrane.total_height - membrane.thickness,
            f"at most resonator.cavity_diameter ({cavity:g} mm)",
        )
    if membrane.boss_diameter is not None and not 0.1 * cavity <= membrane.boss_diameter <= 0.9 * cavity + 1e-9:
        yield conflict(
            "membrane.boss_diameter",
            membrane.boss_diameter,
            (
                f"between {0.1 * cavity:g} and {0.9 * cavity:g} mm, 0.1 to 0.9 of resonator.cavity_diameter ({cavity:g}"
                " mm)"
            ),
        )


def _mold(design: StatedArray) -> Iterator[Refusal]:
    """Sloping walls leave at least half of a rim or boss; trim and shims are small."""
    membrane, mold = design.membrane, design.mold
    slopes = [("membrane.rim_width", membrane.rim_width, membrane.total_height + (membrane.rim_height or 0.0))]
    if membrane.boss_diameter is not None and membrane.boss_height is not None:
        slopes.append(("membrane.boss_diameter", membrane.boss_diameter, 2 * membrane.boss_height))
    for field, width, height in slopes:
        steepest = math.degrees(math.atan(width / 2 / height))
        if mold.draft > steepest:
            yield conflict(
                "mold.draft",
                mold.draft,
                f"at most {steepest:.3g} degrees to leave half of {field} ({width:g} mm)",
                unit="degrees",
            )
    if abs(mold.trim) > _MOST_TRIM * membrane.thickness:
        yield conflict(
            "mold.trim",
            mold.trim,
            f"at most {_MOST_TRIM:g} of membrane.thickness ({membrane.thickness:g} mm), more or less: measure again",
        )
    raised = mold.shim_count * mold.shim_step
    if mold.kind == "two-part" and raised > MOST_SHIMS + 1e-9:
        yield conflict(
            "mold.shim_count",
            mold.shim_count,
            (
                f"at most {int(MOST_SHIMS / mold.shim_step + 1e-09)}: shims of mold.shim_step = {mold.shim_step:g} mm "
                f"may raise the lid by {MOST_SHIMS:g} mm"
            ),
            unit="",
        )
    if mold.vent_diameter > mold.groove_width:
        yield conflict(
            "mold.vent_diameter",
            mold.vent_diameter,
            f"at most mold.groove_width ({mold.groove_width:g} mm), into which the vents lead",
        )


def _board(design: StatedArray) -> Iterator[Refusal]:
    """The board carries the package and closes the chamber."""
    microphone = design.microphone
    narrowest = min(microphone.package_length, microphone.package_width)
    if microphone.sound_hole_diameter > narrowest:
        yield conflict(
            "microphone.sound_hole_diameter",
            microphone.sound_hole_diameter,
            (
                f"at most {narrowest:g} mm, the smaller of microphone.package_length and package_width, for the package"
                " to cover it"
            ),
        )
    for side in ("length", "width"):
        value, least = getattr(microphone, f"board_{side}"), getattr(microphone, f"least_board_{side}")
        if value is not None and value < least - 1e-9:
            yield conflict(
                f"microphone.board_{side}", value, f"at least {least:g} mm to cover package, chamber and gasket"
            )
    if microphone.gasket_width is not None:
        for field, tube, to_microphone in design.stated_tubes():
            deepest = microphone.chamber_height / 2 - tube.outer_diameter / 2 - design.printing.glue_gap - SOCKET_COVER
            if to_microphone and microphone.gasket_depth > deepest + 1e-9:
                yield conflict(
                    "microphone.gasket_depth",
                    microphone.gasket_depth,
                    f"at most {deepest:.3g} mm to stay {SOCKET_COVER:g} mm above the socket of {field}",
                )


def _sound_hole(design: StatedArray) -> Iterator[Refusal]:
    chamber = design.microphone
    if chamber.sound_hole_diameter >= chamber.chamber_diameter:
        yield conflict(
            "microphone.sound_hole_diameter",
            chamber.sound_hole_diameter,
            f"below microphone.chamber_diameter ({chamber.chamber_diameter:g} mm)",
        )


def _print_rules(design: StatedArray) -> Iterator[Refusal]:
    """A rule's advice is on the safe side of its limit."""
    try:
        process_of(design.printing)
    except Refusal as error:
        yield Refusal.of(error, field=f"printing.{error.field}")
