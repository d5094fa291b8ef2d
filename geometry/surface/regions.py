"""The part of a body on which points may be: what the design states, and what a rigid shell takes."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from geometry.body.samples import Samples
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from geometry.schema.surface_fields import SurfaceFit, SurfaceRegion

#: Largest gap between a flat shell and the body under its rim, mm, and smallest radius of the body in those of a shell.
RIM_GAP, LEAST_RADII = 0.65, 1.8
#: Fraction of the region's area above which a separate piece is reported.
_PIECE = 0.02
#: Area above which a part behind a neck narrower than two pitches is reported, squares of the pitch.
_LOBE = 1.5

Mask = NDArray[np.bool_]


@dataclass(frozen=True)
class Region:
    """Where points may be."""

    inside: Mask
    """Samples of the region, (n,)."""
    from_edge: Array
    """Distance of each sample from the edge of the region, (n,) float64, mm; 0 outside, infinite without an edge."""
    findings: tuple[str, ...]
    """Sentences on what was left out."""


def shell_radius_limit(outer: float) -> float:
    """Smallest radius of a body on which a flat shell of that outer radius stands, mm."""
    return max(LEAST_RADII * outer, outer**2 / (2 * RIM_GAP))


def region_of(samples: Samples, stated: SurfaceFit, outer: float, pitch: float) -> Region:
    """The largest piece of what a design states, without what is bent too far.

    Args:
        samples: of the body.
        stated: the table ``[surface]``.
        outer: outside radius of the shells, mm.
        pitch: distance between neighbours, mm.

    Raises:
        Refusal: nothing is left, the body is bent too far, or the region is narrower than two pitches somewhere.
    """
    inside = _stated(samples, stated.region)
    if not inside.any():
        problem = "is empty: no part of the body is in all that it states"
        raise Refusal(problem, kind=Kind.CONFLICT, field="surface.region", file=stated.body)
    area = float(samples.areas[inside].sum())
    limit = max(shell_radius_limit(outer), stated.region.least_radius or 0.0)
    bend = samples.bend(outer)
    flat = bend * limit <= 1
    findings = []
    left = inside & flat
    sharp = 1 - float(samples.areas[left].sum()) / area
    if sharp > _PIECE:
        findings.append(f"{100 * sharp:.0f} % of the region is left out: its radius is below {limit:.3g} mm")
    if not left.any():
        worst = samples.places[inside].mean(axis=0)
        raise Refusal(
            f"has radii of {1 / np.median(bend[inside]):.2g} mm around {_words(worst)}; a shell of {2 * outer:.3g} mm "
            f"stands on radii from {limit:.3g} mm",
            kind=Kind.CONFLICT,
            field="surface.region",
            file=stated.body,
            remedy="choose smaller shells or a flatter region",
        )
    pieces, label = _pieces(samples, left)
    sizes = np.bincount(label[left], samples.areas[left], minlength=pieces)
    main = int(np.argmax(sizes))
    others = 1 - sizes[main] / sizes.sum()
    if others > _PIECE:
        findings.append(f"{100 * others:.0f} % of the region is left out: it does not hang together with the rest")
    left = label == main
    from_edge = distance_from_edge(samples, left)
    _check_width(samples, left, from_edge, pitch, stated.body)
    return Region(left, from_edge, tuple(findings))


def distance_from_edge(samples: Samples, inside: Mask) -> Array:
    """Distance of samples of a region from the nearest beside it, (n,) float64, mm; 0 outside, infinite if none is."""
    beside = ~inside & (samples.neighbours @ inside > 0)
    found = np.where(inside, np.inf, 0.0)
    if beside.any():
        found[inside] = cKDTree(samples.places[beside]).query(samples.places[inside])[0]
    return found


def _stated(samples: Samples, region: SurfaceRegion) -> Mask:
    inside = np.ones(len(samples.places), bool)
    if region.faces:
        inside &= np.isin(samples.faces, region.faces)
    if region.normal is not None:
        towards = unit3(region.normal.towards, "surface.region.normal.towards")
        inside &= samples.normals @ towards >= math.cos(math.radians(region.normal.within))
    for number, half in enumerate(region.above):
        normal = unit3(half.normal, f"surface.region.above.{number}.normal")
        inside &= (samples.places - np.array(half.point)) @ normal >= 0
    return inside


def unit3(direction: tuple[float, float, float], field: str) -> Array:
    """A direction of a design as a unit vector, (3,) float64.

    Raises:
        Refusal: it has no length.
    """
    length = math.hypot(*direction)
    if length < 1e-9:
        raise Refusal("has no direction", kind=Kind.OUT_OF_RANGE, field=field, value=list(direction))
    return np.array(direction) / length


def _pieces(samples: Samples, mask: Mask) -> tuple[int, NDArray[np.int_]]:
    """Number of connected pieces of some samples, and the piece of each; -1 for others."""
    count, own = connected_components(samples.neighbours[mask][:, mask], directed=False)
    label = np.full(len(mask), -1)
    label[mask] = own
    return count, label


def _check_width(samples: Samples, inside: Mask, from_edge: Array, pitch: float, body: str) -> None:
    """Refuse a region that is nowhere two pitches wide, or whose parts hang together by less than that."""
    widest = float(from_edge[inside].max())
    if widest < pitch * 0.98:
        where = samples.places[int(np.argmax(np.where(inside, from_edge, -1.0)))]
        raise Refusal(
            f"is at most {2 * widest:.3g} mm wide, around {_words(where)}; it must be two pitches wide "
            f"({2 * pitch:.3g} mm)",
            kind=Kind.CONFLICT,
            field="surface.region",
            file=body,
            remedy="choose a smaller pitch or a wider region",
        )
    core = inside & (from_edge >= 0.75 * pitch)
    pieces, label = _pieces(samples, core)
    sizes = np.bincount(label[core], samples.areas[core], minlength=pieces)
    lobes = np.flatnonzero(sizes > _LOBE * pitch**2)
    if len(lobes) > 1:
        small = lobes[np.argsort(sizes[lobes])][0]
        where = samples.places[label == small].mean(axis=0)
        raise Refusal(
            f"is narrower than two pitches ({2 * pitch:.3g} mm) between its parts; one of them is around "
            f"{_words(where)}",
            kind=Kind.CONFLICT,
            field="surface.region",
            file=body,
            remedy="choose a smaller pitch, or one of the parts",
        )


def _words(place: Array) -> str:
    return f"({', '.join(f'{each:.1f}' for each in place)}) mm"
