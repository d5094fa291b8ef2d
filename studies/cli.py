"""The command line ``acoustic-fem``: one verb per job, exit codes, and errors in one line.

Verbs of one subject share a module ``cli_*``. Nothing heavy is imported before a verb needs it.
"""

from __future__ import annotations

import signal
import sys
import warnings
from typing import Annotated, NoReturn, TextIO

import typer

from geometry.refusal import Refusal
from studies import (
    cli_bending,
    cli_calibrate,
    cli_convert,
    cli_design,
    cli_live,
    cli_localizer,
    cli_locate,
    cli_optimize,
    cli_recalibrate,
    cli_report,
    cli_sweep,
    cli_tolerance,
    cli_wiring,
)
from studies.cli_options import Fidelity

__all__ = ["Fidelity", "app", "fail", "main"]

app = typer.Typer(
    name="acoustic-fem",
    help="Design of acoustic tactile arrays: one design file in; transfer functions, a localizer and printable parts "
    "out. Begin with: [bold]acoustic-fem run array-2x6 --out demo[/bold]",
    no_args_is_help=True,
    add_completion=False,
    rich_markup_mode="rich",
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)
#: In the order of work, which is that of ``--help``.
VERBS = (
    cli_design.prototypes,
    cli_design.check,
    cli_wiring.wiring,
    cli_design.solve,
    cli_design.parts,
    cli_calibrate.calibrate,
    cli_recalibrate.recalibrate,
    cli_convert.convert,
    cli_localizer.train,
    cli_localizer.evaluate,
    cli_locate.onnx,
    cli_locate.locate,
    cli_live.live,
    cli_design.run,
    cli_bending.bend,
    cli_sweep.sweep,
    cli_tolerance.tolerance,
    cli_optimize.optimize,
    cli_report.report,
    cli_report.best,
)


def main() -> NoReturn:
    """Run the command line: exit code 0; 1 with one line on stderr for bad input; 2 for a wrong command line."""
    warnings.showwarning = _show_warning
    signal.signal(signal.SIGTERM, _stop)
    try:
        app(prog_name="acoustic-fem")
    except KeyboardInterrupt:
        fail("stopped", 130)
    except Refusal as error:
        fail(str(error))
    except OSError as error:
        if error.filename is None:
            raise  # a mistake of the program: its traceback says where
        fail(f"{error.filename}: {error.strerror}")
    sys.exit(0)


def _stop(*_: object) -> NoReturn:
    """End in order when told to: child programs are ended and temporary folders removed on the way out."""
    signal.signal(signal.SIGTERM, signal.SIG_IGN)  # a second one would cut that short
    fail("stopped", 143)


def fail(message: str, code: int = 1) -> NoReturn:
    """End with one line on stderr."""
    print("acoustic-fem: " + " ".join(message.split()), file=sys.stderr)
    sys.exit(code)


def _show_warning(
    message: Warning | str,
    category: type[Warning],
    filename: str,
    lineno: int,
    file: TextIO | None = None,
    line: str | None = None,
) -> None:
    print(f"note: {message}", file=sys.stderr)


def _print_version(wanted: bool) -> None:
    if wanted:
        from importlib.metadata import PackageNotFoundError, version

        try:
            print(f"acoustic-fem {version('acoustic-fem')}")
        except PackageNotFoundError:
            print("acoustic-fem, run from a checkout without an installation")
        raise typer.Exit


@app.callback()
def _root(
    version: Annotated[
        bool, typer.Option("--version", callback=_print_version, is_eager=True, help="Print the version and stop.")
    ] = False,
) -> None: ...


for verb in VERBS:
    app.command()(verb)

if __name__ == "__main__":
    main()
