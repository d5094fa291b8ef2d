"""Land patterns of microphones: the pads under a package, and where its sound hole lies among them."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from importlib import resources

from pydantic import Field

import geometry
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.text_files import parse_toml
from geometry.schema.field_errors import Millimetre, Number, Section, model_of

_FILE = "stock/land_patterns.toml"


class LandPad(Section):
    """Rectangular pad under a package."""

    number: str = Field(min_length=1, max_length=4, description="number of the pin")
    x: Number = Field(ge=-20, le=20, description="middle of the pad along the package, mm")
    y: Number = Field(ge=-20, le=20, description="middle of the pad across the package, mm")
    length: Millimetre = Field(le=10, description="size along the package")
    width: Millimetre = Field(le=10, description="size across the package")


class LandPattern(Section):
    """Pads under a package with the sound hole at its bottom, mm, seen from the side of the package.

    The origin is the middle of the package, x points from the pads to the sound hole, y to the left of x.
    """

    title: str = Field(description="package in words")
    port: Number = Field(ge=0, le=20, description="x of the sound hole, mm")
    ring: str = Field(min_length=1, max_length=4, description="number of the pin of the ring around the sound hole")
    ring_inner: Millimetre = Field(le=10, description="inner diameter of the ring")
    ring_outer: Millimetre = Field(le=10, description="outer diameter of the ring")
    pads: tuple[LandPad, ...] = Field(min_length=1, description="other pads")
    source: str = Field(min_length=1, description="source of the sizes")


@lru_cache(maxsize=1)
def land_patterns() -> Mapping[str, LandPattern]:
    """Land patterns that come with the package, by name."""
    text = (resources.files(geometry) / _FILE).read_text(encoding="utf-8")
    given = parse_toml(text, _FILE, Refusal)
    return {
        name: model_of(LandPattern, table, _FILE, "file of land patterns", Refusal, name)
        for name, table in given.items()
    }


def find_land_pattern(name: str) -> LandPattern:
    """The land pattern of a name.

    Raises:
        Refusal: no such land pattern.
    """
    known = land_patterns()
    if name not in known:
        raise Refusal(kind=Kind.UNKNOWN, field="land_pattern", value=name, allowed=known)
    return known[name]
