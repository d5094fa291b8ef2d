"""Tables and lines that the verbs print on the console."""

from __future__ import annotations

import os
import textwrap
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING

from rich import box
from rich.console import Console
from rich.table import Column, Table

from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import counted, in_one_line, visible
from geometry.layout.cutting import cutting_list
from geometry.schema.declared_fields import fields_of
from studies.kit.jobs import BUILD, BUY
from studies.verdict import figure_rows, reason_lines

if TYPE_CHECKING:
    from acoustic_fem import Library
    from geometry.printing.printability import PrintReport
    from studies.kit.making import MadeParts
    from studies.verdict import Verdict

#: Blanks of a table: at both its edges, and between columns.
_EDGES, _GAP = 2, 3
#: Texts are broken between words in columns that keep at least so many characters; numbers never are.
_LEAST_TEXT = 24
#: Characters of a line into a file or a pipe, where a row is a line however long it is.
_UNBROKEN = 100_000
#: Characters of a line of a check into a file or a pipe, where tables hold sentences that people read.
_NARROW = 80
#: Problems of one kind that are printed.
_FIRST = 10


def table_of(*columns: str, numbers: tuple[int, ...] = ()) -> Table:
    """An empty table; columns at the indices ``numbers`` are aligned to the right."""
    table = Table(box=box.SIMPLE_HEAD, pad_edge=False)
    for index, column in enumerate(columns):
        table.add_column(column, justify="right" if index in numbers else "left", no_wrap=True)
    return table


def tell(text: str) -> None:
    """Print one line on stdout, whatever names stand in it."""
    print(in_one_line(text))


def say(text: object) -> None:
    """Print a text on stdout as it is, but for control characters: a text of a file must not steer the terminal."""
    print(visible(str(text)))


def show(table: Table, *, unbroken: int = _UNBROKEN) -> None:
    """Print a table on stdout.

    On a terminal it is as wide as that, or as ``COLUMNS`` says: long texts are broken between words, and columns that
    do not fit follow in blocks beneath. Into a file or a pipe it is as wide as it takes.

    Args:
        table: the table.
        unbroken: largest number of characters of a line into a file or a pipe.
    """
    console = Console(width=_terminal_width() or unbroken, markup=False, highlight=False)
    table = _visible(table)
    first, *rest = range(len(table.columns))
    while rest:
        count = len(rest)
        while count > 1 and _widths(table, [first, *rest[:count]], console.width) is None:
            count -= 1
        console.print(_part(table, [first, *rest[:count]], console.width))
        rest = rest[count:]


def show_narrow(table: Table) -> None:
    """Print a table that holds sentences: its lines are short in a file, too."""
    show(table, unbroken=_NARROW)


def tell_wrapped(text: str) -> None:
    """Print one line on stdout; on a terminal a long one goes on below, broken between words."""
    line, width = in_one_line(text), _terminal_width()
    inside = len(line) - len(line.lstrip(" -"))
    print(line if width is None else textwrap.fill(line, width, subsequent_indent=" " * inside, break_long_words=False))


def _terminal_width() -> int | None:
    """Characters of a line of the terminal, or those that ``COLUMNS`` says; None into a file or a pipe."""
    return Console().width if Console().is_terminal or "COLUMNS" in os.environ else None


def _visible(table: Table) -> Table:
    """The same table without control characters in its cells."""
    numbers = tuple(place for place, column in enumerate(table.columns) if column.justify == "right")
    plain = table_of(*(visible(str(column.header)) for column in table.columns), numbers=numbers)
    for cells in zip(*(column.cells for column in table.columns), strict=True):
        plain.add_row(*(visible(str(cell)) for cell in cells))
    return plain


def _widths(table: Table, chosen: list[int], most: int) -> list[int] | None:
    """Widths of some columns of a table: headings are narrowed first, then texts; None where that is not enough."""
    columns = [table.columns[k] for k in chosen]
    widths = [max(_longest(str.splitlines, each.header), _longest(str.splitlines, *each.cells)) for each in columns]
    room = most - _EDGES - _GAP * (len(chosen) - 1)
    for least in (_under_headings(columns), _under_texts(columns)):
        while sum(widths) > room and any(width > own for width, own in zip(widths, least, strict=True)):
            wide = [k for k in range(len(chosen)) if widths[k] > least[k]]
            widths[max(wide, key=lambda k: widths[k])] -= 1
    return widths if sum(widths) <= room else None


def _under_headings(columns: list[Column]) -> list[int]:
    """Widths of columns whose headings are broken between words, and whose cells are whole."""
    return [max(_longest(str.split, each.header), _longest(str.splitlines, *each.cells)) for each in columns]


def _under_texts(columns: list[Column]) -> list[int]:
    """Widths of columns whose texts are broken between words too, but keep room for a few; numbers never are."""
    whole = _under_headings(columns)
    return [
        width if column.justify == "right" else max(min(width, _LEAST_TEXT), _longest(str.split, *column.cells))
        for width, column in zip(whole, columns, strict=True)
    ]


def _longest(parts: Callable[[str], list[str]], *texts: object) -> int:
    """Characters of the longest part of some texts."""
    return max((len(part) for text in texts for part in parts(str(text))), default=0)


def _part(table: Table, chosen: list[int], most: int) -> Table:
    """A table of some columns of another, for a console so wide; lines go on as far in as they begin."""
    columns = [table.columns[k] for k in chosen]
    widths = _widths(table, chosen, most) or [most] * len(chosen)
    numbers = tuple(place for place, column in enumerate(columns) if column.justify == "right")
    part = table_of(*(str(column.header) for column in columns), numbers=numbers)
    for cells in zip(*(column.cells for column in columns), strict=True):
        part.add_row(*(_wrapped(str(cell), width) for cell, width in zip(cells, widths, strict=True)))
    for column, width in zip(part.columns, widths, strict=True):
        column.header = _wrapped(str(column.header), width)
    return part


def _wrapped(text: str, width: int) -> str:
    """A text in lines of at most so many characters, words whole."""
    return "\n".join(
        wrapped
        for line in text.splitlines()
        for wrapped in textwrap.wrap(
            line, width, subsequent_indent=line[: len(line) - len(line.lstrip())], break_long_words=False,
            break_on_hyphens=False,
        )
    )  # fmt: skip


def show_fields() -> None:
    """Every field of a design file."""
    table = table_of("field", "range", "default")
    for field in fields_of(ArrayDesign):
        stated = str(field.default).lower() if isinstance(field.default, bool) else str(field.default)
        default = "required" if field.required else "" if field.default in (None, "", {}) else stated
        allowed = field.allowed or field.kind
        name = f"{field.name}\n  {field.description}"
        table.add_row(name, allowed, default if field.kind != "a table" else "")
    show(table)


def show_folded(where: str, rows: Iterable[tuple[str, str]]) -> None:
    """Print a line for each table that is not printed: its title and its worst finding.

    Args:
        where: heading, which says where the tables are.
        rows: title and worst finding of each.
    """
    table = table_of(where, "worst finding")
    for row in rows:
        table.add_row(*row)
    show_narrow(table)


def show_verdict(verdict: Verdict) -> None:
    """Print a verdict: its outcome, the worst reasons with their remedies, and the four figures."""
    say(f"{verdict.design.name}: {verdict.outcome}")
    for line in reason_lines(verdict):
        tell_wrapped(line)
    table = table_of("figure", "value", "remark", numbers=(1,))
    for row in figure_rows(verdict):
        table.add_row(*row)
    show_narrow(table)


def show_library(path: Path, library: Library) -> None:
    """A library that was written, in one line."""
    points, microphones, frequencies = (
        library.transfer_function.sizes[name] for name in ("point", "microphone", "frequency")
    )
    tell(
        f"{path}: {counted(points, 'point')}, {counted(microphones, 'microphone')}, {counted(frequencies, 'frequency')}"
    )
    cells = library.provenance.get("cells") or [{}]
    if (known := cells[0].get("errors_up_to_hz")) is not None and library.frequency[-1] > known:
        tell(f"fidelity atlas: errors are known up to {known:g} Hz, the library ends at {library.frequency[-1]:g} Hz")


def show_parts(made: MadeParts) -> None:
    """Print the parts with their files, the tubes to cut, the bill, and the page that says where each part goes."""
    table = table_of("part", "count", "volume (mm^3)", "files", numbers=(1, 2))
    for name in dict.fromkeys(file.part for file in made.files):
        own = [file for file in made.files if file.part == name]
        words = ", ".join(file.path.relative_to(made.folder).as_posix() for file in own[:1])
        words += "".join(f", {file.path.suffix}" for file in own[1:]) + "".join(
            f"; also {other}" for other in own[0].also
        )
        words += "" if own[0].count else "; spare, on no plate: all are in the carrier"
        table.add_row(name, str(own[0].count), f"{own[0].cad_volume:.1f}", words)
    show(table)
    table = table_of(
        "tube", "count", "sheath (mm)", "spring (mm)", "bore (mm)", "outside (mm)", numbers=(1, 2, 3, 4, 5)
    )
    for cut in cutting_list(made.design):
        lengths = f"{cut.cut_length:g}", f"{cut.spring_length:g}"
        table.add_row(
            cut.place, str(cut.count), *lengths, f"{cut.tube.inner_diameter:g}", f"{cut.tube.outer_diameter:g}"
        )
    show(table)
    bill = made.bill
    money = bill.currency
    say(
        f"resin {bill.resin_ml:.3g} ml and {bill.tooling_resin_ml:.3g} ml in molds, "
        f"silicone {bill.silicone_ml:.3g} ml, tube {bill.tube_m:.3g} m: "
        f"about {bill.cost:.2f} {money}, molds {bill.tooling_cost:.2f} {money}"
    )
    order = made.order
    say(
        f"with spares, tools and consumables {order.cost():.2f} {money}; {order.hours:.1f} h of work and "
        f"{order.waiting:.0f} h of waiting ({BUY}/order-list.csv)"
    )
    say(f"which part goes to which point, and which tube between: {BUILD}/assembly.txt")
    for name in made.too_large:
        tell(f"note: {name} is too large for {made.printing.process.name}, so it is on no plate")
    show_notes(made.notes, made.misfits)


def show_notes(notes: tuple[str, ...], misfits: tuple[str, ...]) -> None:
    """Print the parts that could not be built as drawn, and the first parts that do not fit together."""
    for note in notes:
        tell_wrapped(f"note: {note}")
    show_first(misfits, "note: {}")


def show_first(lines: tuple[str, ...], form: str) -> None:
    """The first of some lines, and how many more there are."""
    for line in lines[:_FIRST]:
        tell_wrapped(form.format(line))
    if len(lines) > _FIRST:
        say(form.format(f"and {counted(len(lines) - _FIRST, 'more problem')}"))


def show_findings(printing: PrintReport) -> None:
    """The print verdict and what leads to it."""
    tell(f"printing, {printing.process.title}: {printing.verdict}")
    if printing.problems:
        table = table_of("part, measure and place (mm)", "value", "must be", "verdict", numbers=(1,))
        for finding in printing.problems:
            value = f"{finding.value:.3g} {finding.unit}"
            limit = f"{finding.relation} {finding.limit:.3g} {finding.unit}"
            place = "" if finding.place is None else ", ".join(f"{0.0 + round(x, 2):g}" for x in finding.place)
            measure = f"{finding.rule} at {place}" if place else finding.rule
            table.add_row(f"{finding.part}\n  {measure}", value, limit, finding.verdict)
        show_narrow(table)
