"""Refusals as data: kind, file, field, value and what is allowed; the sentence is made of them."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Mapping
from enum import Enum, StrEnum
from os import PathLike, fspath
from typing import Any, Self, TypeAlias

_LONGEST_WORD = 300
_LONGEST_LINE = 2000
_LONGEST_VALUE = 80
#: Categories of what shows nothing and turns, breaks or ends a line: controls, marks of direction, lone surrogates.
_UNSEEN = {"Cc", "Cf", "Cs", "Zl", "Zp"}


class Kind(StrEnum):
    """Reason why an input is not accepted, for programs that react to it."""

    MISSING = "missing"
    """A file, field, channel or recording that must be there is not."""
    UNREADABLE = "unreadable"
    """A file is not of its format, is cut short, or may not be read."""
    DAMAGED = "damaged"
    """A file's content is not that which was written: its checksum differs."""
    UNKNOWN = "unknown"
    """A name that nothing here has: a key, a metric, a prototype."""
    WRONG_TYPE = "wrong type"
    """A value of another type or shape than the field has."""
    OUT_OF_RANGE = "out of range"
    """A value outside its range, or not one of its choices."""
    CONFLICT = "conflict"
    """Two values, each allowed, that exclude each other."""
    MISMATCH = "mismatch"
    """Two things that do not belong together: a library and a recording, a store and a study, versions."""
    UNSUITABLE = "unsuitable"
    """Data that cannot answer the question: silent, clipped, too short, unphysical."""
    EXISTS = "exists"
    """Something stands where the output would be written, or another process writes there."""
    NOT_INSTALLED = "not installed"
    """A package or a system library that is needed is missing."""
    NO_RESULT = "no result"
    """A computation found no answer that holds: not converged, outside its validity."""
    STOPPED = "stopped"
    """A process, worker, device or connection ended before its result was there."""


#: Messages of Python, and what they say in plain words.
_PLAIN_WORDS = (
    (re.compile(r"could not convert string to float: (.*)"), "{} is not a number"),
    (re.compile(r"invalid literal for int\(\) with base \d+: (.*)"), "{} is not a whole number"),
    (re.compile(r"'[<>]=?' not supported between instances of .*"), "a text and a number cannot be compared"),
    (re.compile(r"math domain error"), "the square root of a negative number"),
    (re.compile(r"unexpected end of data"), "a quote does not end"),
    (re.compile(r"Object arrays cannot be loaded.*"), "it holds Python objects, not numbers"),
)


class Field(str):
    """Name of an argument inside a text of a refusal, or beside its file: a front end shows it by its own name."""

    __slots__ = ()


Text: TypeAlias = str | tuple[str, ...]
"""A text, or its pieces in order, of which some may be :class:`Field`."""


class _NotGiven(Enum):
    NOT_GIVEN = "no value"


class Refusal(ValueError):
    """Input that is not accepted, or from which no result can be computed.

    Every error that the project raises on purpose derives from it, in all four packages: the command line prints
    such an error as one line and lets everything else through as a mistake of the program, with its traceback. Its
    text is that of :func:`in_one_line`: ``file: field = value problem; remedy``.
    """

    NOT_GIVEN = _NotGiven.NOT_GIVEN

    def __init__(
        self,
        problem: Text = "",
        *,
        kind: Kind,
        file: str | PathLike[str] | None = None,
        field: str = "",
        value: object = _NotGiven.NOT_GIVEN,
        unit: str = "",
        allowed: str | Iterable[object] = "",
        remedy: Text = "",
    ) -> None:
        super().__init__()
        self.kind = kind
        """Why."""
        self.file = None if file is None else str(fspath(file))
        """The file that holds the field, or that is itself not accepted."""
        self.field = field
        """Dotted name of the argument or of the file's field; empty where the input as a whole is meant. An argument
        that names the file itself, such as ``out``, is a :class:`Field`: front ends show it by their own name."""
        self.value = value
        """The value that was given; ``Refusal.NOT_GIVEN`` where there is none to show."""
        self.unit = unit
        """Unit of the value, for the sentence."""
        self.allowed = allowed if isinstance(allowed, str) else tuple(allowed)
        """Words that follow "must be", or the choices."""
        self.problem = problem
        """The fault, as a clause that follows the field; made of the other facts where it is empty."""
        self.remedy = remedy
        """A remedy; empty where ``allowed`` says it."""

    def facts(self) -> dict[str, Any]:
        """The arguments that make this refusal again, by name."""
        names = ("problem", "kind", "file", "field", "value", "unit", "allowed", "remedy")
        return {name: getattr(self, name) for name in names}

    @classmethod
    def of(cls, other: Refusal, **changes: Any) -> Self:
        """Another refusal as one of this class, with some of its facts changed, such as the file that it is of."""
        return cls(**{**Refusal.facts(other), **changes})

    def sentence(self, names: Mapping[str, str] | None = None) -> str:
        """The refusal in words.

        Args:
            names: how a front end writes fields, such as ``--full-scale`` for ``full_scale``. Fields of a file keep
                the names that they have there, unless they are a :class:`Field`: an argument that names the file.
        """
        own = {} if names is None or (self.file is not None and not isinstance(self.field, Field)) else names
        subject = own.get(self.field, self.field)
        if self.value is not self.NOT_GIVEN:
            unit = f" {self.unit}" if self.unit and _is_number(self.value) else ""
            subject = f"{subject} = {quoted(self.value)}{unit}" if subject else f"{quoted(self.value)}{unit}"
        problem = (_joined(self.problem, names or {}) or self._usual_problem()) + self._more()
        line = f"{subject} {problem}" if subject else problem
        line = line if self.file is None else f"{self.file}: {line}"
        remedy = _joined(self.remedy, names or {})
        return in_one_line(f"{line}; {remedy}" if remedy else line)

    def _more(self) -> str:
        """Words on other problems than this one, after the first."""
        return ""

    def _usual_problem(self) -> str:
        if isinstance(self.allowed, str):
            must = f"must be {self.allowed}" if self.allowed else ""
        else:
            must = f"must be one of: {', '.join(map(str, self.allowed))}"
        if self.kind is Kind.MISSING and self.value is self.NOT_GIVEN:
            missing = "is missing" if self.field or self.file is None else "no such file"
            return f"{missing}; it {must}" if must else missing
        return must or ("is not known" if self.kind is Kind.UNKNOWN else "is not allowed")

    def __str__(self) -> str:
        return self.sentence()

    def __reduce__(self) -> tuple[Any, ...]:
        return _made_again, (type(self), self.facts()), {**self.__dict__}


def _made_again(cls: type[Refusal], facts: dict[str, Any]) -> Refusal:
    made = cls.__new__(cls)
    Refusal.__init__(made, **facts)
    return made


def _joined(text: Text, names: Mapping[str, str]) -> str:
    pieces = (text,) if isinstance(text, str) else text
    return "".join(names.get(piece, piece) if isinstance(piece, Field) else piece for piece in pieces)


def _is_number(value: object) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def quoted(value: object) -> str:
    """A value as a file would show it, in at most 80 characters: texts in quotes, numbers with twelve digits."""
    if value is None:
        return "nothing"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        return f"{float(value):.12g}"
    text = repr(fspath(value) if isinstance(value, PathLike) else value)
    return text if len(text) <= _LONGEST_VALUE else f"{text[: _LONGEST_VALUE - 3]}..."


def in_one_line(text: str) -> str:
    r"""A text as one line of at most 2000 characters, whatever names and values stand in it.

    Characters that break or turn the line or are hidden become an escape, such as ``\n`` and ``\u202e``, so that a name
    with it is not taken for another; words above 300 characters, and what is then still too long, lose their middle.
    """
    return _without_middle(" ".join(map(_word, text.split(" "))), _LONGEST_LINE)


def said_by(error: BaseException) -> str:
    """Message of a library's error, to be quoted: its lines as one; the class of the error where it has no message.

    Messages of Python itself are put in plain words.
    """
    match error:
        case UnicodeDecodeError():
            return f"byte {error.start} is not {error.encoding.upper()}"
        case ZeroDivisionError():
            return "a division by zero"
        case OverflowError():
            return "a number is too large"
        case RecursionError():
            return "it is nested too deeply"
        case KeyError() if error.args:
            return f"{error.args[0]!r} is missing"
    text = " ".join(str(error).split())
    for pattern, words in _PLAIN_WORDS:
        if found := pattern.fullmatch(text):
            return words.format(*found.groups())
    return text or type(error).__name__


def counted(count: int, noun: str) -> str:
    """How many things there are, in words: ``1 touch``, ``2 touches``.

    Args:
        count: how many.
        noun: one of them, such as ``point`` or ``distinct cell``: the last word takes the plural.
    """
    if count == 1:
        return f"1 {noun}"
    if noun.endswith(("s", "x", "ch", "sh")) and not noun.endswith("epoch"):  # a hard ch
        return f"{count} {noun}es"
    if noun.endswith("y") and noun[-2] not in "aeiou":
        return f"{count} {noun[:-1]}ies"
    return f"{count} {noun}s"


def visible(text: str) -> str:
    r"""A text whose hidden characters, and those that turn or end a line, are shown as escapes, such as ``\x1b``.

    Line feeds and tabs stay: a text from a file may have several lines, but it must not steer the terminal.
    """
    return "".join(letter if letter in "\n\t" else _shown(letter) for letter in text)


def _shown(letter: str) -> str:
    return letter.encode("unicode_escape").decode("ascii") if unicodedata.category(letter) in _UNSEEN else letter


def _word(text: str) -> str:
    return _without_middle("".join(map(_shown, _without_middle(text, _LONGEST_WORD))), _LONGEST_WORD)


def _without_middle(text: str, longest: int) -> str:
    if len(text) <= longest:
        return text
    kept = (longest - 5) // 3
    return f"{text[: longest - 5 - kept].rstrip()} ... {text[-kept:].lstrip()}"
