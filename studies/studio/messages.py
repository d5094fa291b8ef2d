"""Messages from and to a page: what is read from them, and how many numbers are sent."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from typing import Any, TypeGuard

from geometry.ground.refusal import Kind, Refusal
from studies.panels.curves import Curves
from studies.studio.stage import Job

#: Digits of the longest whole number that is read: any such is a finite number too.
_DIGITS = 300
_COUNTS = {2: "two", 3: "three"}


class MessageError(Refusal):
    """A message that no page of ours sends."""


def text_of(message: Mapping[str, Any], key: str) -> str:
    """A text of a message.

    Raises:
        MessageError: it is not a text, or longer than any text of ours.
    """
    value = message.get(key)
    if not isinstance(value, str) or len(value) > 300:
        raise MessageError(kind=Kind.WRONG_TYPE, field=key, allowed="a text of at most 300 characters")
    return value


def read_message(text: str) -> dict[str, Any]:
    """A message of a page.

    Raises:
        MessageError: it is not a table of JSON, or holds what no text and no number of ours can be.
    """
    try:
        message = json.loads(text, parse_int=_whole, parse_constant=_no_number)
        json.dumps(message, ensure_ascii=False).encode()
    except MessageError:
        raise
    except UnicodeEncodeError:
        raise MessageError("a message must be Unicode", kind=Kind.UNREADABLE) from None
    except (ValueError, RecursionError):
        raise MessageError("a message must be JSON", kind=Kind.UNREADABLE) from None
    if not isinstance(message, dict):
        raise MessageError("a message must be a table", kind=Kind.WRONG_TYPE)
    return message


def _whole(text: str) -> int:
    if len(text) > _DIGITS:
        raise MessageError(f"a whole number must have at most {_DIGITS} digits", kind=Kind.OUT_OF_RANGE)
    return int(text)


def _no_number(name: str) -> None:
    raise MessageError(f"{name} is not a number", kind=Kind.WRONG_TYPE)


def written(message: Mapping[str, Any]) -> str:
    """A message to a page; a figure that is not a number is null, which JSON can hold."""
    try:
        return json.dumps(message, separators=(",", ":"), allow_nan=False)
    except ValueError:
        return json.dumps(_finite(message), separators=(",", ":"))


def _finite(value: Any) -> Any:
    if isinstance(value, Mapping):
        return {name: _finite(each) for name, each in value.items()}
    if isinstance(value, (list, tuple)):
        return [_finite(each) for each in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def is_number(value: object) -> TypeGuard[float]:
    """True if a value is a finite number of JSON."""
    return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)


def numbers_of(message: Mapping[str, Any], key: str, count: int) -> tuple[float, ...]:
    """Numbers of a message, such as a place.

    Raises:
        MessageError: they are not so many finite numbers.
    """
    value = message.get(key)
    if not isinstance(value, list) or len(value) != count or not all(map(is_number, value)):
        raise MessageError(kind=Kind.WRONG_TYPE, field=key, allowed=f"{_COUNTS[count]} numbers")
    return tuple(map(float, value))


def place_of(message: Mapping[str, Any], key: str) -> tuple[float, float]:
    """A place in plan, x and y.

    Raises:
        MessageError: it is not a place.
    """
    x, y = numbers_of(message, key, 2)
    return x, y


def packed_signals(header: Mapping[str, Any], found: Mapping[str, Any]) -> bytes:
    """Signals with what was decoded of them, as :func:`packed` has curves."""
    about = {name: value for name, value in found.items() if name != "signals"}
    return _framed({**header, **about}, found["signals"])


def packed(job: Job, curves: Curves, validity: str) -> bytes:
    """Curves as one message: the length of a header in four bytes, the header as JSON, the values as float32.

    Args:
        job: of the curves.
        curves: the curves.
        validity: how far they are from 3-D, in a few words.
    """
    header = {
        "stage": job.stage,
        "revision": job.revision,
        "quantity": curves.quantity,
        "unit": curves.unit,
        "points": list(curves.points),
        "heard_by": list(curves.heard_by),
        "frequency": [float(f"{value:.7g}") for value in curves.frequency],
        "validity": validity,
    }
    return _framed(header, curves.values.astype("<f4").tobytes())


def _framed(header: Mapping[str, Any], values: bytes) -> bytes:
    text = written(header).encode()
    text += b" " * (-len(text) % 4)
    return len(text).to_bytes(4, "little") + text + values
