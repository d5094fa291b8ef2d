"""A refusal is one line of bounded length, whatever the names and values in it."""

from __future__ import annotations

import math
import pickle
import unicodedata
from collections.abc import Callable

import pytest
from hypothesis import given, strategies as st

from geometry.ground.refusal import Kind, Refusal, counted, in_one_line, said_by
from geometry.schema.field_errors import DesignError


@given(st.text(max_size=200), st.sampled_from([1, 10, 10_000]))
def test_any_text_is_one_line_of_bounded_length(text: str, times: int) -> None:
    line = in_one_line(text * times)
    assert len(line) <= 2000
    assert len(line.splitlines()) <= 1
    assert not {unicodedata.category(letter) for letter in line} & {"Cc", "Cf", "Cs", "Zl", "Zp"}
    assert in_one_line(line) == line


def test_a_message_that_is_one_line_stays_as_it_is() -> None:
    message = "mine.toml: tube.length = 0 mm must be above 0 mm; \N{GREEK SMALL LETTER OMEGA}, \N{MINUS SIGN}1"
    assert str(Refusal(message, kind=Kind.OUT_OF_RANGE)) == message


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("a\nb\t c", "a\\nb\\t c"),
        ("\x1b[31mred\x00", "\\x1b[31mred\\x00"),
        ("file\u202egnp.exe", "file\\u202egnp.exe"),
        ("one\u2028two \udcff", "one\\u2028two \\udcff"),
        ("x" * 10_000 + " must be short", "x" * 197 + " ... " + "x" * 98 + " must be short"),
    ],
)
def test_what_breaks_or_turns_a_line_is_shown_as_what_it_is(text: str, line: str) -> None:
    assert in_one_line(text) == line
    assert (
        str(Refusal(text, kind=Kind.OUT_OF_RANGE))
        == str(pickle.loads(pickle.dumps(Refusal(text, kind=Kind.OUT_OF_RANGE))))
        == line
    )


def test_what_a_library_says_in_lines_is_quoted_as_one() -> None:
    assert said_by(OSError("no memory\n  at 0x7f\n")) == "no memory at 0x7f"
    assert said_by(KeyError()) == "KeyError"


def said_of(fails: Callable[[], object]) -> str:
    with pytest.raises(Exception) as found:
        fails()
    return said_by(found.value)


def test_what_python_says_is_put_in_plain_words() -> None:
    assert said_of(lambda: float("x")) == "'x' is not a number"
    assert said_of(lambda: int("x")) == "'x' is not a whole number"
    assert said_of(lambda: {}["x"]) == "'x' is missing"
    assert said_of(lambda: 1 / 0) == "a division by zero"
    assert said_of(lambda: math.sqrt(-1)) == "the square root of a negative number"
    assert said_of(lambda: math.exp(1000)) == "a number is too large"
    assert said_of(lambda: "a" < 1) == "a text and a number cannot be compared"
    assert said_of(lambda: b"\xff".decode()) == "byte 0 is not UTF-8"


def test_errors_of_designs_are_such_lines_too() -> None:
    assert (
        str(DesignError("a\nb", kind=Kind.OUT_OF_RANGE, others=[Refusal("c", kind=Kind.OUT_OF_RANGE)]))
        == "a\\nb (and 1 more problem)"
    )


@pytest.mark.parametrize(
    ("count", "noun", "words"),
    [
        (1, "touch", "1 touch"),
        (2, "touch", "2 touches"),
        (0, "point", "0 points"),
        (3, "body", "3 bodies"),
        (2, "array", "2 arrays"),
        (20, "epoch", "20 epochs"),
        (1, "more problem", "1 more problem"),
    ],
)
def test_one_of_a_thing_is_no_plural(count: int, noun: str, words: str) -> None:
    assert counted(count, noun) == words
