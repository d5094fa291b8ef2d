"""Conditions between the fields of a design, as a study states them: read by hand, never run as code."""

from __future__ import annotations

import ast
import math
import operator
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, NoReturn

import studies.verdict
from geometry import ArrayDesign, DesignError
from geometry.design.design_file import value_of
from geometry.ground.refusal import Kind, Refusal, quoted, said_by
from studies.verdict.rules import OUTCOMES

#: A dotted name; a step after ``materials.`` may hold dashes, an index of a list is a number.
_NAME = re.compile(r"""(?<![\w.'"])(?:materials\.[\w-]+(?:\.\w+)+|[A-Za-z]\w*(?:\.\w+)*)\b(?!\s*\()""")
_TEXT = re.compile(r"""'[^']*'|"[^"]*\"""")
_WORDS = {"and", "or", "not", "in", "True", "False", "None"}
_LONGEST = 500
_EXAMPLE = "give a condition such as 'tube.length > 20 * tube.inner_diameter'"

_ARITHMETIC: dict[type[ast.AST], Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
}
_COMPARISONS: dict[type[ast.AST], Callable[[Any, Any], Any]] = {
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
    ast.Eq: operator.eq,
    ast.NotEq: operator.ne,
}
_FUNCTIONS: dict[str, Callable[..., Any]] = {"min": min, "max": max, "abs": abs, "sqrt": math.sqrt}


VERDICT = "verdict"
"""Name of the verdict in a condition, such as ``verdict != 'does not work'``."""


def read_value(design: ArrayDesign, name: str) -> Any:
    """Value of a name of a condition: a field or a derived value of a design, or its verdict.

    Args:
        design: the design.
        name: dotted name, or :data:`VERDICT`, whose value is the outcome of :class:`studies.Verdict`.

    Raises:
        DesignError: no such name.
        Refusal: a membrane outside what can be solved.
    """
    return studies.verdict.Verdict(design).outcome if name == VERDICT else value_of(design, name)


@dataclass(frozen=True)
class Constraint:
    """Condition on a design."""

    text: str
    """Text of the condition as the study states it, for example ``tube.length > 20 * tube.inner_diameter``."""
    names: tuple[str, ...]
    """Dotted names that it reads: fields and derived values of a design."""
    tree: ast.expr
    """Expression with ``_0``, ``_1``, ... in place of the names."""

    def holds(self, values: Mapping[str, Any]) -> bool:
        """True if the condition holds for these values of its names.

        Raises:
            Refusal: it cannot be computed from these values, such as a division by zero.
        """
        try:
            return bool(_value(self.tree, [values[name] for name in self.names]))
        except (TypeError, ArithmeticError, ValueError, RecursionError) as error:
            problem = f"cannot be computed: {said_by(error)}"
            raise Refusal(problem, kind=Kind.NO_RESULT, field="constraints", value=self.text) from None


def parse_constraint(text: str, base: ArrayDesign) -> Constraint:
    """Condition read from a text: + - * /, comparisons, and, or, not, min, max, abs, sqrt, numbers, texts in quotes.

    Args:
        text: the condition.
        base: a design that knows all names of it.

    Raises:
        Refusal: it cannot be read, is not a condition, or holds a name that the design does not know.
    """

    def refuse(problem: str, kind: Kind = Kind.WRONG_TYPE, remedy: str = "") -> NoReturn:
        raise Refusal(problem, kind=kind, field="constraints", value=text, remedy=remedy) from None

    if len(text) > _LONGEST:
        refuse(f"has {len(text)} characters; it must have at most {_LONGEST}", Kind.OUT_OF_RANGE)
    names: list[str] = []

    def placed(match: re.Match[str]) -> str:
        name = match[0]
        if name in _WORDS:
            return name
        if name not in names:
            names.append(name)
        return f"_{names.index(name)}"

    pieces, end = [], 0
    for literal in _TEXT.finditer(text):  # nothing is a name inside quotes
        pieces += [_NAME.sub(placed, text[end : literal.start()]), literal[0]]
        end = literal.end()
    pieces.append(_NAME.sub(placed, text[end:]))
    try:
        tree = ast.parse("".join(pieces).strip(), mode="eval").body
        _check(tree, len(names))
    except Refusal:
        known = "names, numbers, texts in quotes, + - * /, < <= > >= == !=, and, or, not, min, max, abs and sqrt"
        refuse(f"may only contain {known}", remedy=_EXAMPLE)
    except (SyntaxError, ValueError, RecursionError, MemoryError):  # the last of very many parentheses
        refuse("is not a complete expression", remedy=_EXAMPLE)
    if not isinstance(tree, (ast.Compare, ast.BoolOp, ast.UnaryOp)):
        refuse("must compare two values with <, <=, >, >=, == or !=", remedy=_EXAMPLE)
    values = []
    for name in names:
        try:
            value = OUTCOMES[0] if name == VERDICT else value_of(base, name)
        except DesignError as error:
            refuse(f"names {name}, which {error.problem}", error.kind, str(error.remedy))
        if not isinstance(value, (int, float, str)) and value is not None:
            refuse(f"names {name}, which must be a number or a text, not a table or a list")
        values.append(value)
    if None not in values:  # a value that the base does not give may be a number in each case
        try:
            _value(tree, values)
        except (ArithmeticError, ValueError, RecursionError):  # may be well in each case
            pass
        except TypeError as error:
            refuse(f"cannot be computed: {said_by(error)}")
    return Constraint(text, tuple(names), tree)


def _check(node: ast.AST, count: int) -> None:
    """Refuse what :func:`_value` does not know."""
    match node:
        case ast.BoolOp(values=parts):
            pass
        case ast.UnaryOp(op=ast.Not() | ast.USub() | ast.UAdd(), operand=part):
            parts = [part]
        case ast.BinOp(left=left, op=op, right=right) if type(op) in _ARITHMETIC:
            parts = [left, right]
        case ast.Compare(left=left, ops=ops, comparators=others) if all(type(op) in _COMPARISONS for op in ops):
            parts = [left, *others]
        case ast.Call(func=ast.Name(id=name), args=parts, keywords=[]) if name in _FUNCTIONS and parts:
            pass
        case ast.Name(id=name) if re.fullmatch(r"_\d+", name) and int(name[1:]) < count:
            parts = []
        case ast.Constant(value=float() | int() | str()):
            parts = []
        case _:
            raise Refusal(kind=Kind.WRONG_TYPE)
    for part in parts:
        _check(part, count)


def _value(node: ast.AST, values: list[Any]) -> Any:
    match node:
        case ast.BoolOp(op=ast.And(), values=parts):
            return all(_value(part, values) for part in parts)
        case ast.BoolOp(values=parts):
            return any(_value(part, values) for part in parts)
        case ast.UnaryOp(op=ast.Not(), operand=part):
            return not _value(part, values)
        case ast.UnaryOp(op=ast.USub(), operand=part):
            return -_number(_value(part, values))
        case ast.UnaryOp(operand=part):
            return +_number(_value(part, values))
        case ast.BinOp(left=left, op=op, right=right):
            return _ARITHMETIC[type(op)](_number(_value(left, values)), _number(_value(right, values)))
        case ast.Compare(left=left, ops=ops, comparators=others):
            sides = [_value(part, values) for part in (left, *others)]
            return all(_COMPARISONS[type(op)](a, b) for op, a, b in zip(ops, sides, sides[1:], strict=False))
        case ast.Call(func=ast.Name(id=name), args=parts):
            return _FUNCTIONS[name](*[_number(_value(part, values)) for part in parts])
        case ast.Name(id=name):
            return values[int(name[1:])]
        case ast.Constant(value=value):
            return value
    raise AssertionError(f"unchecked: {ast.dump(node)}")


def _number(value: Any) -> float:
    """A value that is to be computed with: Python would also multiply a text, by any number.

    Raises:
        TypeError: it is not a number.
    """
    if isinstance(value, (int, float)):
        return value
    raise TypeError(f"{quoted(value)} is not a number")
