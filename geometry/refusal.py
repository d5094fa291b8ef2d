"""The one base class of what this project refuses, what a user can mend, and the words of lines for users."""

from __future__ import annotations

import unicodedata

_LONGEST_WORD = 300
_LONGEST_LINE = 2000
#: Categories of what shows nothing and turns, breaks or ends a line: controls, marks of direction, lone surrogates.
_UNSEEN = {"Cc", "Cf", "Cs", "Zl", "Zp"}


class Refusal(ValueError):
    """Input that cannot be taken, or a result that cannot be had from it; the message is one line for a user.

    Every error that the project raises on purpose derives from it, in all four packages: the command line prints
    such an error as one line and lets everything else through as a mistake of the program, with its traceback.
    Whatever the message quotes, its text is that of :func:`in_one_line`.
    """

    def __str__(self) -> str:
        return in_one_line(super().__str__())


def in_one_line(text: str) -> str:
    r"""A text as one line of at most 2000 characters, whatever names and values stand in it.

    What breaks or turns the line or cannot be seen becomes its escape, such as ``\n`` and ``\u202e``, so that a name
    with it is not taken for another; words above 300 characters, and what is then still too long, lose their middle.
    """
    return _without_middle(" ".join(map(_word, text.split(" "))), _LONGEST_LINE)


def said_by(error: BaseException) -> str:
    """What an error of a library says, to be quoted: its lines as one; the kind of the error where it says nothing."""
    return " ".join(str(error).split()) or type(error).__name__


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


def _word(text: str) -> str:
    text = _without_middle(text, _LONGEST_WORD)
    seen = (
        letter.encode("unicode_escape").decode("ascii") if unicodedata.category(letter) in _UNSEEN else letter
        for letter in text
    )
    return _without_middle("".join(seen), _LONGEST_WORD)


def _without_middle(text: str, longest: int) -> str:
    if len(text) <= longest:
        return text
    kept = (longest - 5) // 3
    return f"{text[: longest - 5 - kept].rstrip()} ... {text[-kept:].lstrip()}"
