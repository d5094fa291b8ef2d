"""Files of localizers: what they say of themselves, as schemas, and the weights of their networks.

Every value is checked before anything is made from it. Sizes are bounded here: what a description asks
for is allocated later without another look.
"""

from __future__ import annotations

import dataclasses
import hashlib
import json
import os
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal, Self, TypeVar, get_type_hints

import torch
from pydantic import BaseModel, ConfigDict, Field, ValidationError, create_model, model_validator
from torch import Tensor

from geometry.files.ordinary import library_reads, read_bytes
from geometry.files.reading import parse_json
from geometry.files.writing import whole_file, write_text
from geometry.refusal import Refusal
from localize.learned.classifier import MapClassifier, NetworkShape
from localize.learned.features import FeatureChoice, map_count
from localize.learned.plan import TrainingPlan
from localize.signals.frames import FRAME
from localize.signals.noise import NoiseChoice
from localize.signals.stimulus import SAMPLE_RATE

_Model = TypeVar("_Model", bound=BaseModel)
_Classifier = TypeVar("_Classifier", bound=MapClassifier)

LARGEST_DESCRIPTION = 20_000_000
"""Most bytes of a description: the largest array has 120,000 points, and a long training a curve of 10,000 epochs."""
LARGEST_MODEL = 256_000_000
"""Most bytes of the weights or the graph of one localizer."""
SEAL = "sha256"
"""Field of a description with the checksum of all its other fields, and of what it describes."""

Digest = Annotated[str, Field(pattern=r"^[0-9a-f]{64}$")]
_Share = Annotated[float, Field(ge=0, le=1)]
_Count = Annotated[int, Field(ge=0, le=2**53)]


class Strict(BaseModel):
    """Fields of exactly these names and kinds, and numbers that are finite."""

    model_config = ConfigDict(strict=True, extra="forbid", allow_inf_nan=False)


class Array(Strict):
    """The array that a localizer is of."""

    design: Annotated[str, Field(min_length=1, max_length=200)]
    microphones: Annotated[
        list[Annotated[str, Field(min_length=1, max_length=100)]], Field(min_length=2, max_length=16)
    ]
    line: Annotated[list[_Count], Field(min_length=2, max_length=120_000)]
    place: Annotated[list[_Count], Field(min_length=2, max_length=120_000)]
    provenance: dict[str, Any]

    @model_validator(mode="after")
    def _agrees(self) -> Self:
        if len(set(self.microphones)) < len(self.microphones):
            raise Refusal(f"microphones = {self.microphones} must be different names")
        if len(self.line) != len(self.place):
            raise Refusal(f"line and place must hold {len(self.line)} values each, a line and a place of every point")
        if not isinstance(self.provenance.get("design", ""), str):
            raise Refusal("provenance.design must be a text")
        return self


class Network(Strict):
    """Fields of :class:`localize.learned.classifier.NetworkShape`, which checks how they go together."""

    maps: Annotated[int, Field(ge=1, le=1000)]
    points: Annotated[int, Field(ge=2, le=120_000)]
    width: Annotated[int, Field(ge=1, le=1024)]
    depths: Annotated[list[Annotated[int, Field(ge=1, le=32)]], Field(min_length=1, max_length=8)]
    patch: Annotated[list[Annotated[int, Field(ge=1, le=64)]], Field(min_length=2, max_length=2)]
    merge_last: bool
    features: FeatureChoice

    def shape(self) -> NetworkShape:
        """Sizes of the network.

        Raises:
            Refusal: sizes that do not go together.
        """
        cut = (self.patch[0], self.patch[1])
        return NetworkShape(**{**self.model_dump(), "depths": tuple(self.depths), "patch": cut})


class _Plan(Strict):
    @model_validator(mode="after")
    def _in_range(self) -> Self:
        TrainingPlan(**{name: getattr(self, name) for name in type(self).model_fields})
        return self


def _plan_model() -> type[_Plan]:
    """Schema of the fields of a plan, whose ranges it checks itself."""
    later = {"FeatureChoice": FeatureChoice, "NoiseChoice": NoiseChoice}
    kinds = get_type_hints(TrainingPlan, localns=later)
    fields: dict[str, Any] = {each.name: (kinds[each.name], ...) for each in dataclasses.fields(TrainingPlan)}
    return create_model("Plan", __base__=_Plan, **fields)


if TYPE_CHECKING:
    Plan = _Plan
else:
    Plan = _plan_model()


class Training(Strict):
    """The record of a training; that of recordings comes on top."""

    model_config = ConfigDict(extra="allow")

    loss: Annotated[list[float], Field(max_length=10_000)]
    held_out_accuracy: Annotated[list[_Share], Field(max_length=10_000)]
    epochs: _Count
    touches: _Count
    held_out_touches: _Count
    seconds: Annotated[float, Field(ge=0)]
    cut_short: bool
    microphone_noise: Annotated[float, Field(ge=0, le=100)]
    sensors: _Count
    device: str


class LocalizerDescription(Array):
    """What ``localizer.json`` says."""

    format: str
    version: int
    weights: Annotated[str, Field(pattern=r"^weights-[0-9a-f]{12}\.safetensors$")]
    weights_sha256: Digest
    network: Network
    plan: Plan
    training: Training
    sha256: Digest

    @model_validator(mode="after")
    def _fits(self) -> Self:
        if len(self.line) != self.network.points:
            raise Refusal(f"line and place must hold {self.network.points} values, as network.points says")
        maps = map_count(len(self.microphones), self.network.features)
        if self.network.maps != maps:
            raise Refusal(f"network.maps = {self.network.maps} must be {maps} for {len(self.microphones)} microphones")
        return self


class GraphDescription(Array):
    """What an ONNX file says of itself."""

    format: str
    version: int
    kind: Literal["network", "model-based decoder"]
    sample_rate: float
    frame: int
    unit: str
    noise_rms: Annotated[float, Field(ge=0, le=100)]
    opset: _Count
    versions: dict[str, Any]
    sha256: Digest | None = None

    @model_validator(mode="after")
    def _as_signals_are(self) -> Self:
        for name, value in (("sample_rate", SAMPLE_RATE), ("frame", FRAME), ("unit", "Pa")):
            if getattr(self, name) != value:
                raise Refusal(f"{name} = {getattr(self, name)!r} must be {value!r}")
        return self


class TrainingState(Strict):
    """Fields of :class:`localize.learned.checkpoint.Progress`."""

    step: _Count
    turned: _Share
    seconds: Annotated[float, Field(ge=0)]
    losses: list[float]
    curve: Annotated[list[tuple[_Count, _Count, float, _Share, float, dict[str, _Share]]], Field(max_length=10_000)]


def check_format(
    values: object,
    format: str,
    version: int,
    source: str | os.PathLike[str],
    refusal: Callable[[str], Exception],
    what: str = "a localizer",
) -> None:
    """Refuse a description of something else, or of another version of the program, before its values are looked at.

    Args:
        values: what a JSON text states.
        format: what its field of this name must be.
        version: the same.
        source: where it stands, put before the message.
        refusal: makes the error of a message.
        what: what it should be of.

    Raises:
        Exception: by ``refusal``.
    """
    if not isinstance(values, dict) or values.get("format") != format:
        raise refusal(f"{source}: not {what}: its format is not {format!r}")
    if values.get("version") != version:
        raise refusal(f"{source}: version = {values.get('version')} must be {version}")


def described(
    model: type[_Model], text: str | bytes, source: str | os.PathLike[str], refusal: Callable[[str], Exception]
) -> _Model:
    """What a JSON text states, checked.

    Args:
        model: the schema.
        text: the text, which was read as JSON.
        source: where it stands, put before the message.
        refusal: makes the error of a message.

    Raises:
        Exception: by ``refusal``, in one line: a value that is missing, unknown or not allowed.
    """
    try:
        return model.model_validate_json(text)
    except ValidationError as error:
        found = error.errors(include_url=False)[0]
        where = ".".join(str(step) for step in found["loc"])
        if found["type"] == "missing":
            raise refusal(f"{source}: {where!r} is missing") from None
        said = str(found.get("ctx", {}).get("error") or found["msg"])
        if found["type"] == "value_error":
            raise refusal(f"{source}: {where}{': ' * bool(where)}{said}") from None
        shown = json.dumps(found["input"], default=str)
        raise refusal(f"{source}: {where} = {shown:.80} is refused: {said[:1].lower()}{said[1:]}") from None


def sealed(description: dict[str, Any], content: bytes = b"") -> dict[str, Any]:
    """A description with the checksum of its other fields, and of the content that it describes."""
    return {**description, SEAL: _checksum(description, content)}


def is_sealed(description: dict[str, Any], content: bytes = b"") -> bool:
    """Whether a description and its content are as :func:`sealed` left them."""
    own = {name: value for name, value in description.items() if name != SEAL}
    return description.get(SEAL) == _checksum(own, content)


def _checksum(description: dict[str, Any], content: bytes) -> str:
    text = json.dumps(description, sort_keys=True, ensure_ascii=True)
    return hashlib.sha256(text.encode("ascii") + b"\n" + content).hexdigest()


def save_model(path: Path, description: Mapping[str, Any], classifier: MapClassifier) -> None:
    """Write a description and the weights it names into a folder, which is made.

    The description is renamed into place last: a run that is killed leaves the model that was there before.

    Args:
        path: of the description.
        description: what it says, but for the weights and its checksum.
        classifier: the network.
    """
    from safetensors.torch import save

    path.parent.mkdir(parents=True, exist_ok=True)
    weights = save({name: value.contiguous() for name, value in classifier.state_dict().items()})
    digest = hashlib.sha256(weights).hexdigest()
    name = f"weights-{digest[:12]}.safetensors"
    with whole_file(path.parent / name) as beside:
        beside.write_bytes(weights)
    write_text(path, json.dumps(sealed({**description, "weights": name, "weights_sha256": digest}), indent=1))
    for old in path.parent.glob("weights-*.safetensors"):
        if old.name != name:
            old.unlink()


def read_model(
    path: Path, model: type[_Model], kind: tuple[str, int, str], refusal: type[Refusal]
) -> tuple[dict[str, Any], _Model, dict[str, Tensor]]:
    """Read what :func:`save_model` wrote.

    Args:
        path: of the description.
        model: its schema, with the fields ``weights`` and ``weights_sha256``.
        kind: its format and version, and what it is of, such as "a localizer".
        refusal: class of the errors.

    Returns:
        What the description says, the same checked, and the weights by name, each of the shape of its layer.

    Raises:
        Refusal: of the class given: a file is missing, cut short, changed, too large or of something else, or a value
            in it is not allowed.
    """
    from safetensors.torch import load

    format, version, what = kind
    text = read_bytes(path, f"{what}'s description", refusal, LARGEST_DESCRIPTION)
    values = parse_json(text, str(path), refusal)
    check_format(values, format, version, path, refusal, what)
    said = described(model, text, path, refusal)
    if not is_sealed(values):
        raise refusal(f"{path}: changed or damaged: its checksum is not that of what it says")
    weights_path = path.parent / values["weights"]
    weights = read_bytes(weights_path, f"the weights of {what}", refusal, LARGEST_MODEL)
    if hashlib.sha256(weights).hexdigest() != values["weights_sha256"]:
        raise refusal(f"{weights_path}: cut short or changed: its checksum is not the one in {path.name}")
    with library_reads(weights_path, f"the weights of {what}", refusal):
        return values, said, load(weights)


@contextmanager
def naming(path: Path, refusal: type[Refusal]) -> Iterator[None]:
    """Refusals within name the file, and are of the class given."""
    try:
        yield
    except Refusal as error:
        raise refusal(f"{path}: {error}") from None


def with_weights(make: Callable[[], _Classifier], weights: Mapping[str, Tensor]) -> _Classifier:
    """Network with weights that fit it, ready to name; it is laid out without memory first, so that it never takes
    more than they do.

    Args:
        make: makes the network.
        weights: of it, by name.

    Raises:
        Refusal: other weights than the network has, or some that are not finite.
    """
    with torch.device("meta"):
        wanted = make().state_dict()
    for name in sorted({*wanted, *weights}):
        if name not in wanted or name not in weights:
            raise Refusal(
                f"the weights do not fit the network: {name} is {'none of it' if name in weights else 'missing'}"
            )
        mine, other = ((tuple(each[name].shape), each[name].dtype) for each in (wanted, weights))
        if mine != other:
            raise Refusal(f"the weights do not fit the network: {name} is {other}, must be {mine}")
        if not torch.isfinite(weights[name]).all():
            raise Refusal(f"the weights hold a value of {name} that is not finite")
    classifier = make()
    classifier.load_state_dict(dict(weights))
    return classifier.eval()
