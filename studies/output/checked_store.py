"""Zarr stores whose damage is noticed: a CRC-32C in every chunk, and a SHA-256 of everything that says what they hold.

The hashes stand in the attribute ``checksums`` of the group, by member: ``attribute title``, ``tube.length/zarr.json``,
``tube.length/c/0`` for the values of what is never written again and, for what describes an array and changes no number
of it, ``tube.length/zarr.json attributes``. All of them make the attribute ``identity``, under which the blocks that
follow are sealed. Stores of older versions have no checksums, or no identity; they open, and that is said.
"""

from __future__ import annotations

import hashlib
import json
import warnings
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any, Literal, TypeVar

import numpy as np
from numpy.typing import NDArray
from pydantic import BaseModel, ConfigDict, NonNegativeInt, ValidationError

from geometry.ground.file_checks import library_reads, read_bytes
from geometry.ground.refusal import Refusal
from geometry.ground.text_files import parse_json
from geometry.ground.whole_files import write_text

#: Attribute of the group.
CHECKSUMS = "checksums"
IDENTITY = "identity"
"""Attribute that tells a store from all that say or hold something else."""
#: First format whose stores have an identity, and the first one with checksums.
_IDENTIFIED, _CHECKED = 3, 2
METADATA = "zarr.json"
"""File that says what a group or an array is."""
#: Most bytes of a zarr.json: the study of a sweep with a million values in it.
_LARGEST = 100_000_000
#: Most values of an array that is read whole.
_LARGEST_ARRAY = 100_000_000
Refuse = type[Refusal]


class StoreWarning(UserWarning):
    """Damage to a store that changes no number, or a store in which damage cannot be noticed."""


class _Group(BaseModel):
    model_config = ConfigDict(strict=True)
    zarr_format: Literal[3]
    node_type: Literal["group"]
    attributes: dict[str, Any]


class _Array(BaseModel):
    model_config = ConfigDict(strict=True)
    zarr_format: Literal[3]
    node_type: Literal["array"]
    shape: list[NonNegativeInt]
    attributes: dict[str, Any] = {}


Schema = TypeVar("Schema", bound=BaseModel)


@dataclass(frozen=True)
class CheckedStore:
    """Store whose attributes are those that were written, and what is known of its arrays."""

    path: Path
    """Folder of the store."""
    attributes: dict[str, Any]
    """Attributes of the group."""
    checked: bool
    """Whether it has checksums."""
    identity: str
    """Identity under which its blocks are sealed; empty where they are not, in older stores."""
    described: dict[str, dict[str, Any]]
    """Attributes of each array that is not broken."""
    broken: dict[str, str]
    """What is wrong with arrays, by name: their ``zarr.json`` is missing or damaged."""
    refusal: Refuse
    """Maker of the error of a message."""

    def array(self, name: str, writing: bool = False) -> Any:
        """Array of Zarr, into which every chunk is written, also one that holds nothing but fill values.

        Args:
            name: of the array.
            writing: whether it will be written to.

        Raises:
            Exception: by ``refusal``: its ``zarr.json`` is missing or damaged.
        """
        import zarr

        if name in self.broken or not (self.path / name / METADATA).is_file():
            raise self.refusal(f"{self.path}: {self.broken.get(name, f'{name}/{METADATA} is missing')}")
        whole = {"array.write_empty_chunks": True}
        with library_reads(f"{self.path}: {name}", "a Zarr array", self.refusal), zarr.config.set(whole):
            return zarr.open_array(self.path / name, mode="r+" if writing else "r", zarr_format=3)

    def has_chunk(self, name: str, chunk: int, dimensions: int = 1) -> bool:
        """Whether a chunk that was written is there; of stores without checksums nobody knows.

        Args:
            name: of the array, which is cut along its first axis only.
            chunk: along that axis.
            dimensions: how many axes it has.
        """
        return not self.checked or self.chunk_file(name, chunk, dimensions).is_file()

    def chunk_file(self, name: str, chunk: int, dimensions: int = 1) -> Path:
        """File of a chunk; arguments as for :meth:`has_chunk`."""
        return self.path.joinpath(name, "c", str(chunk), *["0"] * (dimensions - 1))

    def part(self, array: Any, name: str, part: Any) -> NDArray[Any]:
        """Values of an array, as they are indexed, in the shape of what is asked for; texts as Python's.

        Raises:
            Exception: by ``refusal``: a chunk is damaged.
        """
        with library_reads(f"{self.path}: {name}", "what was written", self.refusal):
            values = np.asarray(array[part])
        return values.astype(object) if values.dtype.kind == "T" else values

    def small(self, name: str, kind: str = "") -> NDArray[Any]:
        """All values of an array with one axis, (n,).

        Args:
            name: of the array.
            kind: letters of NumPy for the kinds of values that it may hold; by default any.

        Raises:
            Exception: by ``refusal``: it is missing, damaged, larger than any that was written, or of another kind.
        """
        array = self.array(name)
        if array.ndim != 1 or array.size > _LARGEST_ARRAY:
            raise self.refusal(f"{self.path}: {name} has shape {array.shape}; it must have one axis, and fewer values")
        values = self.part(array, name, slice(None))
        if kind and values.dtype.kind not in kind:
            raise self.refusal(f"{self.path}: {name} holds {values.dtype}, which nobody wrote")
        return values

    def fixed(self, name: str, kind: str = "") -> NDArray[Any]:
        """All values of an array with one axis and one chunk that is never written again, (n,); as :meth:`small`."""
        values = self.small(name, kind)
        member = f"{name}/c/0"
        if not self.has_chunk(name, 0):
            raise self.refusal(f"{self.path}: {member} is missing")
        if self.identity and self.attributes[CHECKSUMS].get(member) != values_digest(values):
            raise self.refusal(f"{self.path}: {member} is not what was written there")
        return values


# -- writing ----------------------------------------------------------------------------------------
def create_checked(
    group: Any,
    name: str,
    shape: Sequence[int],
    dtype: str,
    chunks: Sequence[int],
    dimensions: Sequence[str],
    attributes: dict[str, Any],
    fill: float | str | None = None,
) -> Any:
    """New array of a group, each of whose chunks is compressed and has a CRC-32C.

    Args:
        group: the Zarr group.
        name: of the array.
        shape: of the array.
        dtype: Zarr's name of the type.
        chunks: shape of a chunk; the array is cut along its first axis only.
        dimensions: names of the axes.
        attributes: of the array.
        fill: value of what was not written.
    """
    from zarr.codecs import Crc32cCodec, ZstdCodec

    more = {} if fill is None else {"fill_value": fill}
    return group.create_array(
        name, shape=tuple(shape), dtype=dtype, chunks=tuple(chunks), dimension_names=tuple(dimensions),
        attributes=attributes, compressors=(ZstdCodec(level=0), Crc32cCodec()), config={"write_empty_chunks": True},
        **more,
    )  # fmt: skip


def add_checksums(path: Path, filled: Collection[str]) -> None:
    """Put the hashes of what a new store says of itself into its attributes, and the identity that they make.

    Args:
        path: of the store.
        filled: arrays that are filled block by block from now on; all others keep their values.
    """
    import zarr

    with warnings.catch_warnings():  # it says that the third version of the format has not settled how
        warnings.filterwarnings("ignore", "Consolidated metadata is currently not part", UserWarning)
        zarr.consolidate_metadata(path, zarr_format=3)  # where other programs look first; none of it changes any more
    document = json.loads((path / METADATA).read_text(encoding="utf-8"))
    attributes = document["attributes"]
    found = {f"attribute {name}": _digest(value) for name, value in attributes.items()}
    for place in sorted(path.glob(f"*/{METADATA}")):
        name = place.parent.name
        found |= _array_digests(name, json.loads(place.read_text(encoding="utf-8")))
        if name not in filled:
            found[f"{name}/c/0"] = values_digest(np.asarray(zarr.open_array(place.parent, mode="r", zarr_format=3)[:]))
    attributes[IDENTITY] = _digest(found)
    found[f"attribute {IDENTITY}"] = _digest(attributes[IDENTITY])
    attributes[CHECKSUMS] = found
    write_text(path / METADATA, json.dumps(document, indent=2))


def take_checksums(path: Path, other: CheckedStore, names: Collection[str]) -> None:
    """Take the hashes of some arrays from a store that has the same ones; it must have checksums."""
    document = json.loads((path / METADATA).read_text(encoding="utf-8"))
    for member, digest in other.attributes[CHECKSUMS].items():
        if member.partition("/")[0] in names:
            document["attributes"][CHECKSUMS][member] = digest
    write_text(path / METADATA, json.dumps(document, indent=2))


def _array_digests(name: str, document: dict[str, Any]) -> dict[str, str]:
    rest = {key: value for key, value in document.items() if key != "attributes"}
    member = f"{name}/{METADATA}"
    return {member: _digest(rest), f"{member} attributes": _digest(document.get("attributes"))}


def values_digest(values: NDArray[Any]) -> str:
    """SHA-256 of values, numbers or texts, and of their shape and type; hexadecimal."""
    if values.dtype.kind in "OUT":
        return _digest([list(values.shape), *map(str, values.ravel())])
    plain = np.ascontiguousarray(values, values.dtype.newbyteorder("<"))
    head = _digest([list(plain.shape), plain.dtype.str])
    return hashlib.sha256(head.encode() + plain.tobytes()).hexdigest()


def _digest(value: Any) -> str:
    return hashlib.sha256(json.dumps(value, sort_keys=True).encode()).hexdigest()


# -- reading ----------------------------------------------------------------------------------------
def read_store(
    path: Path, what: str, mark: str, form: int, schema: type[Schema], described: Collection[str], refusal: Refuse
) -> tuple[CheckedStore, Schema]:
    """What a store says of itself, each member the one that was written; damage that changes no number is told.

    Args:
        path: of the store.
        what: such as ``the results of a sweep``, for messages.
        mark: attribute that marks such a store and states its format.
        form: latest format that is known; from 2 on there are checksums, from 3 on an identity.
        schema: of the attributes.
        described: attributes that change no number.
        refusal: class of the errors.

    Raises:
        Exception: by ``refusal``: no such store, one of a later format, or one whose group or attributes are damaged;
            names the member.
    """
    if not (path / METADATA).exists():
        raise refusal(f"{path}: is not {what}: it has no {METADATA}")
    attributes: dict[str, Any] = _document(path, METADATA, _Group, refusal)["attributes"]
    found = attributes.get(mark)
    if isinstance(found, bool) or not isinstance(found, int) or found < 1:
        raise refusal(f"{path}: {METADATA}: is not {what}: its attribute {mark} is {found!r}")
    if found > form:
        raise refusal(f"{path}: is of format {found}, which a later version wrote; this one reads up to {form}")
    stored = attributes.get(CHECKSUMS)
    if found >= _CHECKED and not isinstance(stored, dict):
        raise refusal(f"{path}: {METADATA}: attribute {CHECKSUMS} is damaged: it must be a table")
    if isinstance(stored, dict):
        _check_attributes(path, attributes, stored, described, refusal)
    else:
        _tell(f"{path}: has no checksums, an older version wrote it; damage to it cannot be noticed")
    try:
        checked = schema.model_validate(attributes)
    except ValidationError as error:
        raise refusal(f"{path}: {METADATA}: attribute {_first(error)}") from None
    identity = attributes.get(IDENTITY, "")
    if found >= _IDENTIFIED and not (isinstance(identity, str) and identity):
        raise refusal(f"{path}: {METADATA}: attribute {IDENTITY} is missing")
    if found == _CHECKED:
        _tell(f"{path}: has no identity, an older version wrote it; parts of other stores in it cannot be noticed")
    arrays, broken = _arrays(path, stored)
    identity = identity if found >= _IDENTIFIED else ""
    return CheckedStore(path, attributes, isinstance(stored, dict), identity, arrays, broken, refusal), checked


def _document(path: Path, member: str, schema: type[BaseModel], refusal: Refuse) -> dict[str, Any]:
    """A ``zarr.json``."""
    content = read_bytes(path / member, f"a {METADATA}", refusal, _LARGEST)
    document = parse_json(content, f"{path}: {member}", refusal)
    try:
        schema.model_validate(document)
    except ValidationError as error:
        raise refusal(f"{path}: {member}: {_first(error)}") from None
    return dict(document)


def _first(error: ValidationError) -> str:
    """What is wrong first, in words."""
    wrong = error.errors(include_url=False)[0]
    return f"{'.'.join(map(str, wrong['loc'])) or 'its content'}: {wrong['msg']}"


def _check_attributes(
    path: Path, attributes: dict[str, Any], stored: dict[str, Any], described: Collection[str], refusal: Refuse
) -> None:
    found = {f"attribute {name}": _digest(value) for name, value in attributes.items() if name != CHECKSUMS}
    written = [member for member in stored if member.startswith("attribute ")]
    for member in dict.fromkeys([*found, *written]):
        if found.get(member) == stored.get(member):
            continue
        wrong = f"{path}: {METADATA}: {member} is {'damaged' if member in found else 'missing'}"
        if member.removeprefix("attribute ") not in described:
            raise refusal(wrong)
        _tell(f"{wrong}; it changes no result")


def _arrays(path: Path, stored: dict[str, Any] | None) -> tuple[dict[str, dict[str, Any]], dict[str, str]]:
    """Attributes of the arrays; and those that are there or should be and cannot be taken as they are, and why."""
    names = {place.parent.name for place in path.glob(f"*/{METADATA}")}
    names |= {member.partition("/")[0] for member in stored or () if "/" in member}
    described: dict[str, dict[str, Any]] = {}
    broken: dict[str, str] = {}
    for name in sorted(names):
        member = f"{name}/{METADATA}"
        if not (path / member).is_file():
            broken[name] = f"{member} is missing"
            continue
        try:
            document = _document(path, member, _Array, _Broken)
        except _Broken as error:
            broken[name] = str(error).removeprefix(f"{path}: ").removeprefix(f"{path}/")
            continue
        described[name] = document.get("attributes", {})
        if stored is None:
            continue
        for each, digest in _array_digests(name, document).items():
            if stored.get(each) != digest and each != member:
                _tell(f"{path}: {each} are damaged; they change no result")
            elif stored.get(each) != digest:
                broken[name] = f"{member} is damaged"
    return described, broken


class _Broken(Refusal):
    """Why an array cannot be taken."""


@lru_cache(maxsize=1000)
def _tell(note: str) -> None:
    """Warn once, however often a store is opened."""
    warnings.warn(note, StoreWarning, stacklevel=1)
