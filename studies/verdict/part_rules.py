"""Figures of the verdict that follow from sizes alone: the layout, the process, the target, the membranes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

import acoustic_fem
from acoustic_fem.membrane.design_discs import design_disc
from acoustic_fem.membrane.disc import KnownDiscs
from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import Refusal
from geometry.ground.typed import Array
from geometry.layout.arrangement import lay_out, point_axes
from geometry.layout.overlaps import overlaps
from geometry.layout.size import array_size
from geometry.layout.straight_rows import is_wide_apart
from geometry.printing.print_rules import Finding
from geometry.schema.print_processes import Rule, process_of
from geometry.stock import catalogue
from localize.contacts.contact import hertz_fraction
from studies.metrics.build import cost, smallest_wall
from studies.metrics.covered_area import coverage
from studies.verdict.measured import NOT_JUDGED, Measured, points_in_words
from studies.verdict.rules import rule_named
from studies.verdict.tap_levels import covered_forces

CLEAR = (1 / 3, 1.5)
"""Estimates of the deflection by the height, below and above which the estimate decides. Finite elasticity gave 0.5 to
1.4 times the estimate for eleven designs."""
STIFFENING = 0.443
"""Cubic stiffening of a clamped plate under a force in its middle: w + 0.443 w^3 / h^2 is the linear deflection, for an
edge that cannot move (Timoshenko and Woinowsky-Krieger 1959, article 97, table 82)."""


def buildable(design: ArrayDesign, misfits: Sequence[str] = ()) -> Measured:
    """Number of things that keep the array from being put together; ``misfits`` are those of the drawn parts."""
    found = (() if is_wide_apart(design) else overlaps(design, lay_out(design))) or tuple(misfits)
    if not found:
        return Measured(0.0, "the array can be put together")
    more = f" and {len(found) - 1} more" if len(found) > 1 else ""
    return Measured(float(len(found)), f"the array cannot be put together: {found[0]}{more}")


def printable(design: ArrayDesign, failures: Sequence[Finding] = ()) -> Measured:
    """Smallest ratio of a size to the limit of the process; ``failures`` are those that the print report found."""
    process = process_of(design.printing)
    sizes = [
        (1.0 if rule.verdict(size) != "fail" and size < rule.limit else size / rule.limit, what, size, rule.limit)
        for what, size, rule in _printed(design)
    ]
    for each in failures:
        ratio = each.value / each.limit if each.relation == "at least" else each.limit / each.value
        sizes.append((min(ratio, 0.999), f"{each.part}: {each.rule}", each.value, each.limit))
    ratio, what, size, limit = min(sizes)
    return Measured(
        float(ratio),
        f"{what} is {size:.3g} mm, and the limit of {process.name} is {limit:.3g} mm",
    )


def _printed(design: ArrayDesign) -> Iterator[tuple[str, float, Rule]]:
    process = process_of(design.printing)
    yield "the thinnest printed wall", smallest_wall(design), process.wall
    yield "the narrowest printed hole", min(tube.inner_diameter for tube in design.tubes), process.hole
    yield "the gap for glue", design.printing.glue_gap, process.clearance
    thinnest = min(design.of_kind(kind).membrane.thickness for kind in design.kinds)
    yield "the thinnest cast membrane", thinnest, process.cast_thickness


def buyable(design: ArrayDesign) -> Measured:
    """Largest change that makes the design one of parts that can be bought."""
    found = catalogue().fit(design)
    if found.missing:
        nearest = [
            f"{field} (nearest: {found.nearest[field].name})" for field in found.missing if field in found.nearest
        ]
        lacking = ", ".join(nearest or found.missing)
        return Measured(1.0, f"nothing in the catalogue fits {lacking}")
    if not found.changes:
        return Measured(0.0, "all parts are in the catalogue")
    steps = [(_step(change.old, change.new), change) for change in found.changes]
    largest, change = max(steps, key=lambda pair: pair[0])
    words = (
        f"{change.field} of {change.old:.3g} mm cannot be bought, and the nearest is {change.new:.3g} mm "
        f"({change.part.name})"
        if isinstance(change.new, float)
        else f"{change.field} {change.old} cannot be bought, and the nearest is {change.new}"
    )
    return Measured(largest, words)


def _step(old: object, new: object) -> float:
    """Change of a value as a fraction; 0.1 for a part by name, which changes no size."""
    if isinstance(old, int | float) and isinstance(new, int | float):
        return abs(new / old - 1)
    return 0.1


def fits(design: ArrayDesign) -> Measured:
    """Length and width by those of the target, the larger ratio."""
    target = design.target.size
    if target is None:
        return NOT_JUDGED
    length, width, _ = array_size(design)
    long, short = max(length, width), min(length, width)
    allowed_long, allowed_short = max(target), min(target)
    words = f"the array measures {long:.1f} x {short:.1f} mm, and the target is {allowed_long:g} x {allowed_short:g} mm"
    return Measured(max(long / allowed_long, short / allowed_short), words)


def affordable(design: ArrayDesign) -> Measured:
    """Cost by the budget of the target."""
    budget = design.target.budget
    if budget is None:
        return NOT_JUDGED
    price = cost(design)
    return Measured(
        price / budget, f"the materials of one array cost {price:.2f} USD, and the budget is {budget:g} USD"
    )


def covered(design: ArrayDesign) -> Measured:
    """Fraction of the area in which the target's contact touches a membrane."""
    radius = design.target.contact_radius
    fraction = coverage(design, radius)
    words = f"a contact of {radius:g} mm radius touches a membrane in only {100 * fraction:.0f} % of the area"
    return Measured(fraction, words)


def separate(design: ArrayDesign) -> Measured:
    """Largest force on a neighbour's membrane by that on the membrane that the contact is centred on."""
    if design.point_count < 2:
        return NOT_JUDGED
    contact = design.target.contact_radius
    place, radius = point_axes(design), _radii(design)
    distance = np.linalg.norm(place[:, None] - place, axis=-1)
    np.fill_diagonal(distance, np.inf)
    shared = np.zeros(distance.shape)
    own = _own_fraction(radius, contact)
    for size in np.unique(radius):
        rows, columns = np.nonzero((distance < contact + size) & (radius == size))
        shared[rows, columns] = hertz_fraction(distance[rows, columns], contact, float(size))
    ratio = shared / own[:, None]
    limit = rule_named("separate").works
    points = tuple(int(number) + 1 for number in np.flatnonzero(ratio.max(axis=1) > limit))
    first, second = np.unravel_index(ratio.argmax(), ratio.shape)
    words = (
        f"a contact of {contact:g} mm radius on point {first + 1} also presses point {second + 1}, with "
        f"{100 * ratio.max():.0f} % of the force"
    )
    return Measured(float(ratio.max()), words, points)


def bottoming(design: ArrayDesign, known: KnownDiscs | None = None, *, estimated: bool = False) -> Measured:
    """Deflection of the membrane at the target's force by the height of its cavity, or how near it is to tearing.

    Args:
        design: the array.
        known: membranes that need not be solved.
        estimated: whether the estimate also decides between the limits of :data:`CLEAR`, which saves seconds.
    """
    force, found = covered_forces(design), list[tuple[float, float]]()
    for number, kind in enumerate(design.kinds):
        found.append(_pressed(design.of_kind(kind), float(force[design.kind_of_point.index(number)]), known, estimated))
    depth, torn = np.array(found).T[:, list(design.kind_of_point)]
    worse = np.maximum(depth, torn)
    limit = rule_named("bottoming").works
    points = tuple(int(number) + 1 for number in np.flatnonzero(worse > limit))
    where = f"the membrane of {points_in_words(points)}" if points else "the membrane"
    at = f"{design.target.force:g} N"
    words = f"{where} is pressed down by {100 * depth.max():.0f} % of the height of the cavity at {at}"
    if torn.max() > depth.max():
        words = f"{where} bears {100 * torn.max():.0f} % of the force that tears it at {at}"
    return Measured(float(worse.max()), words, points)


def _pressed(design: ArrayDesign, force: float, known: KnownDiscs | None, estimated: bool) -> tuple[float, float]:
    """Deflection by the height of the cavity, and the force by that which tears the membrane; the latter 0 if it is far
    from that, or if the tear limit of its material is not known.
    """
    disc = design_disc(design, known=known)
    linear = 1e3 * disc.displacement_per_force * force
    estimate = stiffened(linear, design.membrane.mounted_thickness) / design.resonator.cavity_height
    if estimated or not CLEAR[0] < estimate < CLEAR[1]:
        return estimate, 0.0
    pressed = acoustic_fem.membrane  # loads finite elements when they are first used
    try:  # takes seconds for proportions that are new, so not in clear cases
        limits = pressed.press_limits(design)
        curve = pressed.press_curve(pressed.design_membrane(design), pressed.SoftPatch())
    except Refusal:  # a membrane that is stretched or shaped
        return estimate, 0.0
    if force >= limits.largest_force:  # nothing is known beyond
        return max(estimate, force / limits.force_at_floor), force / limits.tear_force
    deepest = 1e3 * float(curve.response(force).deepest) / design.resonator.cavity_height
    return deepest, force / limits.tear_force


def stiffened(linear: float, thickness: float) -> float:
    """Deflection of a membrane that stretches, from its linear deflection; both and the thickness in one unit."""
    low, high = 0.0, linear
    for _ in range(60):
        middle = (low + high) / 2
        if middle + STIFFENING * middle**3 / thickness**2 < linear:
            low = middle
        else:
            high = middle
    return high


def _radii(design: ArrayDesign) -> Array:
    radii = np.array([design.of_kind(kind).resonator.cavity_diameter / 2 for kind in design.kinds])
    return np.asarray(radii[list(design.kind_of_point)])


def _own_fraction(radius: Array, contact: float) -> Array:
    """Fraction of a contact's force on the membrane that it is centred on, (n_point,) float64."""
    found = {float(size): hertz_fraction(np.zeros(1), contact, float(size))[0] for size in np.unique(radius)}
    return np.array([found[float(size)] for size in radius])
