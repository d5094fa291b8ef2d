"""The verbs of the command line, known without importing their modules: a list for ``--help``, imported when called."""

from __future__ import annotations

import re
from collections.abc import Callable
from importlib import import_module
from typing import Any, NamedTuple

import typer
from typer.core import TyperCommand, TyperGroup

from geometry.ground.extras import check_extras


class Entry(NamedTuple):
    """A verb of the command line, known without importing its module."""

    module: str
    """Module of this package that has its function."""
    help: str
    """First paragraph of its docstring, for the list of ``--help``."""
    needs: tuple[str, ...] = ()
    """Extras of the installation without which it does nothing; options that need one check it themselves."""


#: Verbs in the order of work, which is that of ``--help``.
VERBS = {
    "prototypes": Entry(
        "new_designs", "List the designs that come with the program, or print one to start your own from."
    ),
    "new": Entry(
        "new_designs",
        "Start a design of your own: where it goes, how many points, how far apart, how many microphones.",
    ),
    "studio": Entry(
        "designs",
        "A page on this machine that shows what a change of a design does: curves, the array in 3-D, points, printing.",
        ("fem", "train", "studies", "studio"),
    ),
    "check": Entry(
        "designs", "Validate a design and say how good it is: counts, wiring, layout, printing, validity of the models."
    ),
    "wiring": Entry(
        "designs", "How many points so many microphones serve, for every number of lines, against the usual wirings."
    ),
    "solve": Entry("designs", "Transfer functions from every point to every microphone."),
    "parts": Entry(
        "designs",
        "Everything to print, cast, cut, buy and assemble, with pictures, and what the print rules say.",
        ("cad",),
    ),
    "rig": Entry("calibrations", "Recordings of a virtual made sensor, to try everything before there is a real one."),
    "calibrate": Entry(
        "calibrations",
        "From recordings of the made sensor to its library: measured transfer functions with their uncertainty.",
        ("plots",),
    ),
    "recalibrate": Entry(
        "calibrations",
        "From touches of which nobody knows the points to the library of the sensor as it is now.",
        ("train",),
    ),
    "convert": Entry(
        "calibrations",
        "A library in another format: netCDF, SOFA (AES69-2022, GeneralTF-E), NPZ or CSV, and back to the last digit.",
    ),
    "train": Entry(
        "localizers",
        "Train a localizer on touches made from a library, and on recorded ones where there are some.",
        ("train",),
    ),
    "evaluate": Entry(
        "localizers",
        "How often a localizer names the touched point, on touches it has never heard; the Bayes decoder beside it.",
        ("train",),
    ),
    "onnx": Entry(
        "locating",
        "Write a localizer as one ONNX graph, from 250 samples of each microphone to the probability of each point.",
        ("train",),
    ),
    "embed": Entry(
        "locating",
        "Write the decoder of a library as C99 for the microcontroller on the sensor: samples in, the touched point "
        "out.",
    ),
    "locate": Entry("locating", "Where and when an array was touched, from a recording of its microphones."),
    "recognize": Entry(
        "locating",
        "What kind each touch of a recording is: events, textures, or the labels that a recognizer was trained on.",
        ("train",),
    ),
    "track": Entry(
        "locating",
        "Where a contact went on the surface, between the points too, from a recording; and gestures by rule.",
    ),
    "pulse": Entry(
        "locating",
        "The pulse under a finger that rests on the array: where it is felt, its rate, the waves of each beat.",
        ("train",),
    ),
    "live": Entry(
        "live_input",
        "Name touches while they happen: listen to the microphones on a sound card, or play a recording in real time.",
    ),
    "run": Entry(
        "designs",
        "Everything for one design: parts, transfer functions, localizer, figures, and report.html.",
        ("fem", "train", "studies"),
    ),
    "bend": Entry(
        "bending",
        "Does a tube transmit less when it is bent? The publication's rig, the bent bore solved in 3-D.",
        ("fem",),
    ),
    "sweep": Entry(
        "sweeps", "Compute many designs: every case of a study with its metrics, into one store.", ("studies",)
    ),
    "tolerance": Entry(
        "searches",
        "What manufacturing scatter does: spread of transfer functions and accuracy, and which tolerance matters most.",
        ("studies", "train"),
    ),
    "optimize": Entry(
        "searches",
        "Search the best designs of a study, of those that can be printed and laid out.",
        ("studies", "train"),
    ),
    "report": Entry(
        "sweeps",
        "One page about a sweep or a search: main effects, pairs, trade-offs, best designs, level and phase "
        "differences.",
        ("studies",),
    ),
    "best": Entry(
        "sweeps", "List the best designs of a sweep or a search, or write the design file of one of them.", ("studies",)
    ),
}


class Verb(TyperCommand):
    """A verb whose options are given once and say something."""

    def __init__(self, *args: Any, help: str | None = None, **kwargs: Any) -> None:
        """Take the docstring without the line ends of its source: a terminal has its own width."""
        super().__init__(*args, help=None if help is None else in_paragraphs(help), **kwargs)

    def invoke(self, ctx: Any) -> Any:
        """Do it, where what it needs is installed.

        Raises:
            MissingExtra: it is not.
        """
        check_extras(f"what {ctx.info_name} needs", *VERBS[ctx.info_name].needs)
        return super().invoke(ctx)

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Read the command line.

        Raises:
            typer.BadParameter: a value is empty, or an option that takes one value is given twice.
        """
        values, _, order = self.make_parser(ctx).parse_args(list(args))
        given: set[str] = set()
        for each in order:
            name = str(each.name)
            label = each.opts[-1] if each.param_type_name == "option" else str(each.metavar)
            if name in given and not each.multiple:
                raise typer.BadParameter(f"{label} is given twice", ctx=ctx)
            given.add(name)
            if "" in (values[name] if isinstance(values[name], (list, tuple)) else [values[name]]):
                raise typer.BadParameter(f"{label} is empty", ctx=ctx)
        return super().parse_args(ctx, args)


def in_paragraphs(text: str) -> str:
    """A text whose paragraphs are one line each."""
    return "\n\n".join(" ".join(each.split()) for each in re.split(r"\n\s*\n", text))


class _Listed(TyperCommand):
    """A verb as ``--help`` lists it; its module is imported when it is called."""

    def make_context(self, info_name: str | None, args: list[str], parent: Any = None, **extra: Any) -> Any:
        """Read the command line as the verb itself does."""
        alone = typer.Typer(add_completion=False, rich_markup_mode="rich", pretty_exceptions_enable=False)
        alone.command(self.name, cls=Verb)(verb_named(str(self.name)))
        return typer.main.get_command(alone).make_context(info_name, args, parent, **extra)


class VerbGroup(TyperGroup):
    """All verbs, none of them imported."""

    def __init__(self, **settings: Any) -> None:
        """List the verbs."""
        settings["commands"] = {name: _Listed(name, help=entry.help) for name, entry in VERBS.items()}
        super().__init__(**settings)


def verb_named(name: str) -> Callable[..., None]:
    """Function of a verb of :data:`VERBS`."""
    verb: Callable[..., None] = getattr(import_module(f"{__package__}.{VERBS[name].module}"), name)
    return verb


#: Arguments of calls whose option has another name; all others are called as the option is.
_OPTIONS = {
    "microphone_noise": "noise",
    "temperature_c": "temperature",
    "frequency": "frequencies",
    "touches_per_point": "touches",
    "rejected_fraction": "reject",
    "loudest_sound_db": "ambient",
    "base_samples": "base",
    "library_size": "library",
    "formats": "format",
    "time_limit": "seconds",
    "subject": "kind",
}


def option_names(verb: str) -> dict[str, str]:
    """How a verb writes the arguments of the call that it makes: ``--full-scale`` for ``full_scale``."""
    alone = typer.Typer(add_completion=False)
    alone.command(verb)(verb_named(verb))
    options = {
        str(each.name): max(each.opts, key=len)
        for each in typer.main.get_command(alone).params
        if each.param_type_name == "option"
    }
    others = {field: options[name] for field, name in _OPTIONS.items() if name in options}
    return {**others, **options}
