"""Files of parts: those that come with the package, and a user's own beside or in place of them."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from functools import lru_cache
from importlib import resources
from pathlib import Path

import geometry
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.text_files import parse_toml, read_toml
from geometry.schema.field_errors import model_of
from geometry.stock.stock_rows import KINDS, StockFile, StockPart

#: Environment variable with files and folders of a user's own parts, separated as in PATH.
VARIABLE = "ACOUSTIC_FEM_STOCK"
_WHAT = "a file of parts"


@lru_cache(maxsize=1)
def built_in_parts() -> tuple[StockPart, ...]:
    """Parts that come with the package."""
    folder = resources.files(geometry) / "stock"
    found: list[StockPart] = []
    for kind in KINDS:
        name = f"stock/{kind}.toml"
        text = (folder / f"{kind}.toml").read_text(encoding="utf-8")
        found += model_of(StockFile, parse_toml(text, name, Refusal), name, _WHAT[2:], Refusal).parts()
    return tuple(found)


def stock_places() -> tuple[Path, ...]:
    """Files and folders that :data:`VARIABLE` names."""
    return tuple(Path(each) for each in os.environ.get(VARIABLE, "").split(os.pathsep) if each)


def stock_files(places: Sequence[Path]) -> Iterator[Path]:
    """The files of some places, those of a folder in the order of their names.

    Raises:
        Refusal: no such file or folder, or a folder without a file.
    """
    for place in places:
        if not place.is_dir():
            yield place
            continue
        files = sorted(place.glob("*.toml"))
        if not files:
            raise Refusal("has no .toml file of parts", kind=Kind.MISSING, file=place)
        yield from files


def read_stock(path: Path) -> StockFile:
    """The parts of a file.

    Raises:
        Refusal: it cannot be read, or a field is missing, unknown or has a value that is not allowed.
    """
    given = read_toml(path, _WHAT, Refusal)
    if not given:
        raise Refusal("has no parts in it", kind=Kind.MISSING, file=path, remedy=f"give one of: {', '.join(KINDS)}")
    return model_of(StockFile, given, str(path), _WHAT[2:], Refusal)


def parts_of(places: Sequence[Path]) -> tuple[StockPart, ...]:
    """The built-in parts and those of some places; a kind that a file replaces has that file's parts alone.

    Raises:
        Refusal: as :func:`stock_files` and :func:`read_stock`.
    """
    own = [read_stock(path) for path in stock_files(places)]
    replaced = {kind for file in own for kind in file.replace}
    kept = [part for part in built_in_parts() if part.kind not in replaced]
    return (*(part for file in own for part in file.parts()), *kept)
