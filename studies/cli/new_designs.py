"""Verbs that begin a design: prototypes, new."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, TypeVar

import typer

from geometry.design.design_file import prototype_names, prototype_text, stated_prototype
from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Refusal, counted
from studies.cli.options import defaults_of, display_on_stderr
from studies.cli.terminal_tables import say, show, table_of, tell
from studies.proposals.design_writing import check_choice, new_design, new_path, write_proposal
from studies.proposals.designer_question import PLACES, question
from studies.run.starting import copy_prototype
from studies.verdict.words import force_in_words

if TYPE_CHECKING:
    from studies.proposals.proposing import Proposals

_Answer = TypeVar("_Answer")
_DEFAULTS = defaults_of(new_design)
#: Length and width that are offered where the place has no usual ones, mm.
_ROOM = (100.0, 60.0)


def prototypes(
    name: Annotated[
        str | None, typer.Argument(metavar="[NAME]", help="Prototype whose design file is printed.")
    ] = None,
    out: Annotated[Path | None, typer.Option(help="Write the design file to this file instead.")] = None,
) -> None:
    """List the designs that come with the program, or print the file of one.

    Example: [bold]acoustic-fem prototypes array-2x6 --out mine.toml[/bold]
    """
    if name is None and out is not None:
        raise typer.BadParameter("--out needs the NAME of a prototype")
    if name is None:
        table = table_of("prototype", "microphones", "points", "description", numbers=(1, 2))
        for known in prototype_names():
            design = stated_prototype(known)
            table.add_row(known, str(len(design.microphones)), str(design.point_count), design.description)
        show(table)
    elif out is None:
        print(prototype_text(name), end="")
    else:
        copy_prototype(name, out)


def new(
    name: Annotated[str, typer.Argument(metavar="NAME", help="Name of the design.")],
    place: Annotated[
        str | None, typer.Option(help="Place of the array: flat, fingertip, wrist or hand. Default: flat.")
    ] = None,
    size: Annotated[
        str | None,
        typer.Option(metavar="MMxMM", help="Length and width in which the array fits with its microphones."),
    ] = None,
    points: Annotated[
        str | None, typer.Option(metavar="N|most", help="Number of points, or the most that work. Default: 12.")
    ] = None,
    rows: Annotated[int | None, typer.Option(help="Number of rows. Default: searched.")] = None,
    columns: Annotated[int | None, typer.Option(help="Points in a row. Default: searched.")] = None,
    pitch: Annotated[
        float | None,
        typer.Option(metavar="MM", help="Distance between neighbouring points. Default: searched, within the size."),
    ] = None,
    around: Annotated[
        float | None, typer.Option(metavar="MM", help="Circumference of the wrist or tool. Default: 188 for a wrist.")
    ] = None,
    microphones: Annotated[int | None, typer.Option(help="Number of microphones. Default: 2, or 3 on a hand.")] = None,
    tubes_below: Annotated[
        str | None, typer.Option(metavar="MM", help="Room below the shells for microphones and their tubes.")
    ] = None,
    printer: Annotated[str, typer.Option(help="Printing process, such as sla-resin or dlp-fine.")] = _DEFAULTS[
        "printer"
    ],
    target: Annotated[str, typer.Option(help="Contact and the smallest force that must be located.")] = _DEFAULTS[
        "target"
    ],
    budget: Annotated[float | None, typer.Option(metavar="USD", help="Highest cost of the parts of one array.")] = None,
    choose: Annotated[
        int | None,
        typer.Option(help="Number of the proposal to write. Default: you are asked on a terminal, otherwise 1."),
    ] = None,
    out: Annotated[Path | None, typer.Option(help="Design file to write. Default: NAME.toml.")] = None,
) -> None:
    """Find a design for your requirements: size, points, touch, printer and cost.

    Searches layouts and parts that can be bought, shows at most three designs with their verdicts, and writes one of
    them. On a terminal the command asks for the most important options that you left out. If no design works, it
    suggests changes of the options that make one possible.

    Example: [bold]acoustic-fem new pad --size 30x30 --points 16 --microphones 2[/bold]
    """
    path = new_path(name, out)
    check_choice(choose)
    given: dict[str, Any] = {
        "place": place, "size": size, "points": points, "rows": rows, "columns": columns, "pitch": pitch,
        "around": around, "microphones": microphones, "tubes_below": tubes_below, "printer": printer,
        "target": target, "budget": budget,
    }  # fmt: skip
    asked = question(**(_dialogue(given) if sys.stdin.isatty() else given))
    with display_on_stderr() as display, display.stage("search") as report:
        report("reading the catalogue and the decoder", 0.0)
        from studies.proposals.proposing import propose  # takes seconds

        found = propose(asked, name, report)
    _show_proposals(found)
    if choose is None and found.works and len(found.designs) > 1 and sys.stdin.isatty():
        choose = _answer(
            f"Design to write (1 to {len(found.designs)})", 1, lambda number: _check_number(number, len(found.designs))
        )
    design = write_proposal(found, path, choose)
    say(path)
    tell(f"{design.description}; {counted(len(design.microphones), 'microphone')}")
    tell(f"next: acoustic-fem check {path} --picture {path.with_suffix('.png')}")


def _dialogue(given: dict[str, Any]) -> dict[str, Any]:
    """Options with answers in place of those that matter most and were not given; each is checked as it is given."""
    known = dict(given)

    def check(values: dict[str, Any]) -> None:
        question(**{**values, "size": values["size"] or _ROOM})  # it may still be asked, and "most" points need one

    def ask(field: str, words: str, usual: Any) -> None:
        if known[field] is None:
            known[field] = _answer(words, usual, lambda value: check({**known, field: value}))

    check(given)  # no answer would make a wrong option right
    if known["around"] is None:
        ask("place", f"Where does it go ({', '.join(PLACES)})?", "flat")
    place = PLACES[known["place"] or "wrist"]
    if place.around is not None:
        ask("around", "Circumference of what it goes around, mm?", place.around)
    elif known["pitch"] is None and known["place"] != "hand":
        usual = place.size or _ROOM
        ask("size", "Length x width, mm?", f"{usual[0]:g}x{usual[1]:g}")
    if known["rows"] is None or known["columns"] is None:
        ask("points", "How many points?", str(place.points))
    ask("microphones", "How many microphones?", place.microphones)
    return known


def _answer(words: str, usual: _Answer, check: Callable[[_Answer], object]) -> _Answer:
    """Answer to a question on a terminal that a check accepts; a wrong one is asked again."""
    while True:
        answer: _Answer = typer.prompt(words, default=usual, type=type(usual))
        try:
            check(answer)
        except Refusal as error:
            typer.echo(str(error), err=True)
        else:
            return answer


def _check_number(number: int, most: int) -> None:
    check_range("number", number, 1, most, whole=True)


def _show_proposals(found: Proposals) -> None:
    """The proposed designs with their trade."""
    if not found.designs:
        return
    table = table_of(
        "",
        "strength",
        "points",
        "size (mm)",
        "smallest tap",
        "taps (%)",
        "cost (USD)",
        "verdict",
        numbers=(0, 2, 4, 5, 6),
    )
    for number, each in enumerate(found.designs, 1):
        figures = each.verdict.figures
        table.add_row(
            str(number),
            each.strength.replace(", ", "\n"),
            str(each.design.point_count),
            " x ".join(f"{side:.1f}" for side in figures.size),
            force_in_words(figures.smallest_force),
            f"{100 * figures.taps:.1f}",
            f"{figures.cost:.2f}",
            each.verdict.outcome,
        )
    show(table)
