"""The verbs of the command line, known without importing their modules: a list for ``--help``, imported when called."""

from __future__ import annotations

import re
from collections.abc import Callable
from enum import Enum
from importlib import import_module
from typing import Any, NamedTuple, get_args

import typer
from typer.core import TyperCommand, TyperGroup

from geometry.ground.argument_checks import reads_as_number
from geometry.ground.extras import check_extras
from geometry.ground.refusal import quoted
from geometry.ground.stated_times import stopped_time


class Entry(NamedTuple):
    """A verb of the command line, known without importing its module."""

    module: str
    """Module of this package that has its function."""
    group: str
    """Part of the work under which ``--help`` lists it."""
    help: str
    """First paragraph of its docstring, for the list of ``--help``."""
    needs: tuple[str, ...] = ()
    """Extras of the installation without which it does nothing; options that need one check it themselves."""


#: Verbs in the order of work, which is that of ``--help``.
VERBS = {
    "prototypes": Entry(
        "new_designs", "Design", "List the designs that come with the program, or print the file of one."
    ),
    "new": Entry(
        "new_designs",
        "Design",
        "Find a design for your requirements: size, points, touch, printer and cost.",
    ),
    "studio": Entry(
        "designs",
        "Design",
        "Edit a design in the browser and see at once what each change does.",
        ("fem", "train", "studies", "studio"),
    ),
    "check": Entry("designs", "Design", "Say whether a design will work, why not, and which change helps most."),
    "fit": Entry(
        "fits",
        "Design",
        "Lay an array on a body from your CAD program, and write the place of every part to a file.",
        ("cad",),
    ),
    "compare": Entry(
        "comparisons",
        "Design",
        "Compare designs, runs, libraries or cases of sweeps side by side.",
        ("fem",),
    ),
    "stock": Entry("stock", "Design", "List the parts that can be bought, with makers, sizes, prices and sources."),
    "wiring": Entry(
        "designs", "Design", "Compare how many points a given number of microphones can serve with different wirings."
    ),
    "solve": Entry("designs", "Design", "Compute the transfer functions from every point to every microphone."),
    "run": Entry(
        "designs",
        "Design",
        "Do everything for one design: parts, transfer functions, localizer and report.",
        ("fem", "train", "studies"),
    ),
    "verify": Entry("designs", "Design", "Check that the folder of a run holds exactly the files that the run wrote."),
    "bend": Entry("bending", "Design", "Compute how much less a tube transmits when it is bent.", ("fem",)),
    "parts": Entry("designs", "Make", "Write everything needed to print, cast, buy and assemble a design.", ("cad",)),
    "rig": Entry(
        "calibrations", "Make", "Simulate recordings of an as-built sensor, to practise before you have a real one."
    ),
    "calibrate": Entry(
        "calibrations",
        "Make",
        "Measure the library of your sensor from recordings with a calibration microphone.",
        ("plots",),
    ),
    "recalibrate": Entry(
        "calibrations",
        "Make",
        "Update the library of your sensor from ordinary touches, whose points need not be known.",
        ("train",),
    ),
    "diagnose": Entry(
        "diagnoses", "Make", "Find what is broken in a built sensor, from a recording of ordinary touches."
    ),
    "train": Entry(
        "localizers", "Use", "Train a network that locates touches, or one that recognizes kinds of touch.", ("train",)
    ),
    "evaluate": Entry(
        "localizers",
        "Use",
        "Measure how accurately a trained network locates touches it was not trained on.",
        ("train",),
    ),
    "locate": Entry("locating", "Use", "Find where and when the array was touched, from a recording."),
    "live": Entry(
        "live_input",
        "Use",
        "Locate touches as they happen, from a sound card, a board, or a recording played in real time.",
    ),
    "record": Entry("live_input", "Use", "Record the samples of a board on a serial port.", ("serial",)),
    "track": Entry("locating", "Use", "Follow a moving contact across the surface, from a recording."),
    "recognize": Entry(
        "locating", "Use", "Classify what kind each touch of a recording is, such as an event or a texture.", ("train",)
    ),
    "pulse": Entry(
        "locating", "Use", "Read the pulse of a finger that rests on the array, from a recording.", ("train",)
    ),
    "onnx": Entry("decoder_exports", "Use", "Export a localizer as one ONNX graph.", ("train",)),
    "embed": Entry("decoder_exports", "Use", "Export the decoder of a library as C99 source for a microcontroller."),
    "convert": Entry(
        "calibrations", "Use", "Convert a library without loss to another format, or to a state space or a circuit."
    ),
    "sweep": Entry("sweeps", "Study", "Compute the metrics of many designs, every case of a study file.", ("studies",)),
    "dataset": Entry(
        "datasets",
        "Study",
        "Write a data set of touches to train networks of your own, readable without this program.",
        ("studies", "train"),
    ),
    "tolerance": Entry(
        "searches",
        "Study",
        "Compute how manufacturing scatter spreads the accuracy, and which tolerance matters most.",
        ("studies", "train"),
    ),
    "optimize": Entry(
        "searches",
        "Study",
        "Search for the best designs of a study file that can be printed and laid out.",
        ("studies", "train"),
    ),
    "report": Entry("sweeps", "Study", "Write one page about a sweep or a search.", ("studies",)),
    "best": Entry(
        "sweeps", "Study", "List the best designs of a sweep or a search, or write the file of one.", ("studies",)
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
            Refusal: ``SOURCE_DATE_EPOCH`` is not a time.
        """
        check_extras(f"what {ctx.info_name} needs", *VERBS[ctx.info_name].needs)
        stopped_time()
        if "own" not in ctx.params:
            return super().invoke(ctx)
        from studies.cli.options import own_stock

        with own_stock(ctx.params):
            return super().invoke(ctx)

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Read the command line.

        Raises:
            typer.BadParameter: a value is empty, not of its type, out of its range or not one of its choices, or an
                option that takes one value is given twice.
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
        try:
            return super().parse_args(ctx, args)
        except typer.BadParameter as error:
            param: Any = getattr(error, "param", None)
            text: Any = values.get(str(getattr(param, "name", "")))
            must = _allowed_words(param, text) if isinstance(text, str) else ""
            if not must:
                raise
            label = param.opts[-1] if param.param_type_name == "option" else str(param.metavar)
            shown = text if reads_as_number(text) else quoted(text)
            raise typer.BadParameter(f"{label} = {shown} must be {must}", ctx=ctx) from None


def _allowed_words(param: Any, text: str) -> str:
    """Words that follow "must be" where the text of an option is refused; empty where the option's type says nothing.

    The parser's own sentences differ between its versions, and quote the library that it checks types with.
    """
    kind = getattr(getattr(param, "type_descriptor", None), "annotation", None)
    older = getattr(param, "type", None)  # of versions before 0.29
    choices = getattr(older, "choices", None) or get_args(kind)
    if isinstance(kind, type) and issubclass(kind, Enum):
        choices = [each.value for each in kind]
    if choices:
        return f"one of: {', '.join(str(getattr(each, 'value', each)) for each in choices)}"
    is_whole = kind is int or getattr(older, "name", "").startswith("integer")
    if not (is_whole or kind is float or getattr(older, "name", "").startswith("float")):
        return ""
    low, high = (getattr(param, name, getattr(older, name, None)) for name in ("min", "max"))
    number = "a whole number" if is_whole else "a number"
    if low is None and high is None:
        return number
    bounds = f"at least {low}" if high is None else f"at most {high}" if low is None else f"between {low} and {high}"
    is_of_its_kind = text.lstrip("+-").isdigit() if is_whole else reads_as_number(text)
    return bounds if is_of_its_kind else f"{number} {bounds}"


def in_paragraphs(text: str) -> str:
    """A text whose paragraphs are one line each."""
    return "\n\n".join(" ".join(each.split()) for each in re.split(r"\n\s*\n", text))


class _Listed(TyperCommand):
    """A verb as ``--help`` lists it; its module is imported when it is called."""

    def make_context(self, info_name: str | None, args: list[str], parent: Any = None, **extra: Any) -> Any:
        """Read the command line as the verb itself does."""
        return command_of(str(self.name)).make_context(info_name, args, parent, **extra)


class VerbGroup(TyperGroup):
    """All verbs, none of them imported."""

    def __init__(self, **settings: Any) -> None:
        """List the verbs."""
        settings["commands"] = {
            name: _Listed(name, help=entry.help, rich_help_panel=entry.group) for name, entry in VERBS.items()
        }
        super().__init__(**settings)


def command_of(name: str) -> Any:
    """Command of a verb of :data:`VERBS`, with its arguments and options; its module is imported."""
    alone = typer.Typer(add_completion=False, rich_markup_mode="rich", pretty_exceptions_enable=False)
    alone.command(name, cls=Verb)(verb_named(name))
    return typer.main.get_command(alone)


def verb_named(name: str) -> Callable[..., None]:
    """Function of a verb of :data:`VERBS`."""
    verb: Callable[..., None] = getattr(import_module(f"{__package__}.{VERBS[name].module}"), name)
    return verb


#: Arguments of calls whose option has another name; all others are called as the option is.
_OPTIONS = {
    "microphone_noise": "noise",
    "contact_radius_mm": "radius",
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
    "volts": "converter_volts",
    "bits": "converter_bits",
    "ir_version": "ir",
}


def option_names(verb: str) -> dict[str, str]:
    """How a verb writes the arguments of the call that it makes: ``--full-scale`` for ``full_scale``."""
    parameters = command_of(verb).params
    options = {str(each.name): max(each.opts, key=len) for each in parameters if each.param_type_name == "option"}
    others = {field: options[name] for field, name in _OPTIONS.items() if name in options}
    return {**others, **options}
