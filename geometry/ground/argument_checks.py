"""Checks of arguments: each returns, or raises a refusal that names the field, its value and what is allowed.

Checks of numbers return them, as floats unless they are whole; the others return nothing. All take more facts of a
refusal by name, such as ``kind``, ``file`` and ``remedy``, and its class as ``error``.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sized
from numbers import Integral
from typing import TYPE_CHECKING, Any

from geometry.ground.refusal import Kind, Refusal, Text

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from geometry.ground.typed import Array

_MOST_DIGITS = 9  # of a number that counts or numbers something


def check_range(
    field: str,
    value: float,
    low: float = -math.inf,
    high: float = math.inf,
    unit: str = "",
    *,
    excluded: str = "",
    whole: bool = False,
    why: str = "",
    error: type[Refusal] = Refusal,
    **more: Any,
) -> float:
    """The number, if it lies in a range; not-a-number is outside every range.

    Args:
        field: name of the argument.
        value: the number.
        low: smallest value.
        high: largest value.
        unit: unit of all three.
        excluded: the bounds that the value must not reach: ``low``, ``high`` or ``both``.
        whole: whether it must be an integer; True and False are not.
        why: words after the range in the message, such as ``the number of points``.
        error: class of the refusal.
        more: more of its facts; ``allowed`` in place of the range in words.

    Raises:
        Refusal: no number, several numbers, or a number out of the range.
    """
    if type(value) not in (int, float, bool) and real_numbers(field, value, error, **more).ndim:
        raise error("must be one number", **{**more, "kind": Kind.WRONG_TYPE, "field": field, "value": value})
    if not whole or _is_whole(value):
        above = value > low if excluded in ("low", "both") else value >= low
        if above and (value < high if excluded in ("high", "both") else value <= high):
            return value if whole else float(value)
    words = _range_in_words(low, high, unit, excluded, whole)
    facts = {"kind": Kind.OUT_OF_RANGE, "unit": unit, "allowed": f"{words}, {why}" if why else words, **more}
    raise error(field=field, value=value, **facts)


def real_numbers(field: str, values: ArrayLike, error: type[Refusal] = Refusal, **more: Any) -> Array:
    """The values as an array, same shape as given, float64, in their unit.

    Raises:
        Refusal: no real numbers: complex numbers, texts, rows of unequal length.
    """
    import numpy as np

    try:
        array = np.asarray(values)
    except ValueError:
        found = "rows of different lengths"
    else:
        if array.dtype.kind in "biuf":
            return np.asarray(array, dtype=np.float64)
        found = {"c": "complex", "U": "text", "S": "text"}.get(array.dtype.kind, type(values).__name__)
    problem = f"must be a real number or an array of them, not {found}"
    raise error(problem, **{**more, "kind": Kind.WRONG_TYPE, "field": field, "value": values})


def positive_numbers(
    field: str, values: ArrayLike, unit: str = "", error: type[Refusal] = Refusal, **more: Any
) -> Array:
    """The values as an array, same shape as given, float64, in their unit, if all are finite and above 0.

    Raises:
        Refusal: no real numbers; or the first value that is not finite or not above 0.
    """
    import numpy as np

    array = real_numbers(field, values, error, **more)
    bad = ~(np.isfinite(array) & (array > 0))
    if bad.any():
        check_range(field, float(array[bad].flat[0]), 0, math.inf, unit, excluded="both", error=error, **more)
    return array


def reads_as_number(text: str) -> bool:
    """True if Python's ``float`` takes a text."""
    try:
        float(text)
    except ValueError:
        return False
    return True


def _is_whole(value: object) -> bool:
    return isinstance(value, Integral) and not isinstance(value, bool)


def _range_in_words(low: float, high: float, unit: str, excluded: str, whole: bool) -> str:
    first, last = (str(bound) if isinstance(bound, int) else f"{bound:g}" for bound in (low, high))
    least = f"above {first}" if excluded in ("low", "both") else f"at least {first}"
    most = f"below {last}" if excluded in ("high", "both") else f"at most {last}"
    if math.isinf(high):
        words = f"finite and {least}" if excluded in ("high", "both") else least
    elif math.isinf(low):
        words = most
    else:
        words = f"{least} and {most}" if excluded else f"between {first} and {last}"
    return f"{'a whole number ' if whole else ''}{words} {unit}".rstrip()


def check_choice(
    field: str, value: object, choices: Iterable[object], error: type[Refusal] = Refusal, **more: Any
) -> None:
    """Reject a value that is not one of the choices, which the refusal lists."""
    allowed = tuple(choices)
    if hasattr(value, "__array__") or value not in allowed:
        raise error(**{"kind": Kind.OUT_OF_RANGE, "field": field, "value": value, "allowed": allowed, **more})


def check_type(
    field: str, value: object, types: tuple[type, ...], allowed: str, error: type[Refusal] = Refusal, **more: Any
) -> None:
    """Reject a value that is of none of some types.

    Args:
        field: name of the argument.
        value: the argument.
        types: those that are accepted.
        allowed: the types in words, which follow "must be".
        error: class of the refusal.
        more: more of its facts.
    """
    if not isinstance(value, types):
        raise error(**{"kind": Kind.WRONG_TYPE, "field": field, "value": value, "allowed": allowed, **more})


def check_shape(
    field: str, values: Any, shape: tuple[int | str, ...], why: str = "", error: type[Refusal] = Refusal, **more: Any
) -> None:
    """Reject an array of another shape.

    Args:
        field: name of the argument.
        values: the array.
        shape: its sizes; a text such as ``n`` stands for any.
        why: words that follow the shape in the message.
        error: class of the refusal.
        more: more of its facts.
    """
    found = tuple(values.shape)
    if len(found) != len(shape) or any(
        own != size for own, size in zip(found, shape, strict=True) if not isinstance(size, str)
    ):
        wanted = f"({', '.join(map(str, shape))}{',' if len(shape) == 1 else ''})"
        problem = f"has shape {found}; it must be {wanted}{', ' if why else ''}{why}"
        raise error(problem, **{"kind": Kind.WRONG_TYPE, "field": field, **more})


def check_given(field: str, values: Sized, why: str = "", *, error: type[Refusal] = Refusal, **more: Any) -> None:
    """Reject a list, mapping or text with nothing in it; ``why`` says what is needed, such as ``a batch needs one``."""
    if not len(values):
        raise error(f"is empty; {why}" if why else "is empty", kind=Kind.MISSING, field=field, **more)


def check_unused(
    given: Mapping[str, object],
    why: Text,
    remedy: Text = "leave it out",
    error: type[Refusal] = Refusal,
    **more: Any,
) -> None:
    """Reject the first of some arguments that is given, because it has no effect beside the other arguments.

    Args:
        given: values of the arguments by name; None or False for one that is not given.
        why: words that follow "has no effect", such as ``: a recording is played at its own rate``.
        remedy: what to do instead.
        error: class of the refusal.
        more: more of its facts.
    """
    problem = ("has no effect", *((why,) if isinstance(why, str) else why))
    for field, value in given.items():
        if value is not None and value is not False:
            shown = {} if value is True else {"value": value}
            raise error(problem, **{"kind": Kind.CONFLICT, "field": field, "remedy": remedy, **shown, **more})


def out_of_range(field: str, value: object, allowed: str | Iterable[object], unit: str = "", **more: Any) -> Refusal:
    """A refusal of a value outside its range; ``allowed`` has the words after "must be", or the choices."""
    return Refusal(kind=Kind.OUT_OF_RANGE, field=field, value=value, unit=unit, allowed=allowed, **more)


def wrong_type(field: str, problem: str, **more: Any) -> Refusal:
    """A refusal of a value of another type or shape than the field has."""
    return Refusal(problem, kind=Kind.WRONG_TYPE, field=field, **more)


def mismatch(field: str, problem: str, **more: Any) -> Refusal:
    """A refusal of two things that do not belong together."""
    return Refusal(problem, kind=Kind.MISMATCH, field=field, **more)


def unsuitable(field: str, problem: str, **more: Any) -> Refusal:
    """A refusal of data that cannot answer the question."""
    return Refusal(problem, kind=Kind.UNSUITABLE, field=field, **more)


def whole_number(text: str) -> int:
    """The number that a text of digits states, from 0; -1 for any other text, and for one of more than nine digits.

    Python also takes digits of other scripts and underscores, and raises an error at very many digits.
    """
    return int(text) if text.isascii() and text.isdigit() and len(text) <= _MOST_DIGITS else -1
