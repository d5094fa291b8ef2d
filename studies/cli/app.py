"""The command line ``acoustic-fem``: one verb per job, exit codes, and errors in one line.

Verbs are listed in :mod:`studies.cli.verbs`; those of one subject share a module, imported when one is called.
"""

from __future__ import annotations

import errno
import re
import signal
import subprocess
import sys
import sysconfig
import warnings
from io import TextIOWrapper
from pathlib import Path
from types import FrameType
from typing import Annotated, Any, NoReturn, TextIO

import typer

from geometry.ground.extras import what_to_install
from geometry.ground.refusal import Refusal, in_one_line, said_by
from geometry.ground.system_libraries import what_is_missing
from geometry.ground.whole_files import FULL
from studies.cli.environment import check_environment
from studies.cli.verbs import VERBS, VerbGroup, option_names

__all__ = ["app", "fail", "main"]


def pages_folder() -> Path:
    """Folder of the documentation: of the checkout, or where an installation put it."""
    checkout = Path(__file__).parents[2] / "docs"
    return (
        checkout
        if (checkout / "calibration.md").is_file()
        else Path(sysconfig.get_path("data")) / "share" / "doc" / "acoustic-fem"
    )


app = typer.Typer(
    name="acoustic-fem",
    cls=VerbGroup,
    help="Design acoustic tactile sensors. From one design file you get transfer functions, a localizer and printable "
    "parts. Begin with: [bold]acoustic-fem run array-2x6 --out demo[/bold]",
    no_args_is_help=True,
    epilog=f"The guides that this help names, such as docs/calibration.md, are in {pages_folder()}",
    add_completion=False,
    rich_markup_mode="rich",
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)
#: Exit code of what Ctrl-C ended, as shells have it.
_INTERRUPTED = 130
_LONGEST_ARGUMENT = 4096  # no system has longer paths


#: Wrong command lines: what typer raises for them all.
_USAGE: Any = typer.BadParameter.__base__
_NO_MEMORY = re.compile(
    r"(not enough|out of) memory|(cannot|can't|unable to|failed to) (allocate|map segment|start new thread)|bad_alloc",
    re.I,
)
#: What the system says of a disk that takes nothing more, whoever writes to it.
_FULL = (*FULL, errno.EROFS)


def main() -> NoReturn:
    """Run the command line: exit code 0; 1 with one line on stderr for bad input; 2 for a wrong command line."""
    warnings.showwarning = _show_warning
    if isinstance(sys.stdout, TextIOWrapper):
        sys.stdout.reconfigure(errors="backslashreplace")  # names of files may be no text
    for argument in sys.argv[1:]:
        if len(argument) > _LONGEST_ARGUMENT:
            fail(f"{argument}: an argument of {len(argument)} characters must have at most {_LONGEST_ARGUMENT}", 2)
    signal.signal(signal.SIGTERM, _stop)
    interrupt = _Interrupt()
    if signal.getsignal(signal.SIGINT) not in (signal.SIG_IGN, None):  # else nobody wants to be stopped by it
        signal.signal(signal.SIGINT, interrupt)
    try:
        check_environment()
        code = app(sys.argv[1:] or ["--help"], prog_name="acoustic-fem", standalone_mode=False)
    except (KeyboardInterrupt, typer.Abort):
        fail("stopped", _INTERRUPTED)
    except Exception as error:
        if interrupt.pressed:  # libraries that were being imported make other errors of it
            fail("stopped", _INTERRUPTED)
        _tell(error)
        raise  # a mistake of the program: its traceback says where
    if code == _INTERRUPTED:  # which is what typer makes of Ctrl-C, in silence
        fail("stopped", _INTERRUPTED)
    sys.exit(code if isinstance(code, int) else 0)


class _Interrupt:
    """Handler of Ctrl-C, which remembers that it was pressed."""

    pressed = False

    def __call__(self, number: int, frame: FrameType | None) -> None:
        """Interrupt what is done, as Python does it."""
        self.pressed = True
        signal.default_int_handler(number, frame)


def _tell(error: Exception) -> None:
    """End with one line where something was refused, or the command line, the system or an installation is wrong."""
    if isinstance(error, Refusal):
        verb = next((each for each in sys.argv[1:] if each in VERBS), None)
        fail(error.sentence(option_names(verb) if verb else {}))
    if isinstance(error, _USAGE):
        message = error.format_message().removeprefix("Invalid value: ").rstrip(".")
        fail(f"{message}; try {error.ctx.command_path if error.ctx else 'acoustic-fem'} --help", 2)
    if _lacks_memory(error):
        fail(f"there is not enough memory: {said_by(error)}; end other programs, or ask for less at once")
    if not isinstance(error, (ImportError, OSError)):
        return
    if missing := what_is_missing(str(error)):
        fail(missing)
    if isinstance(error, ModuleNotFoundError) and (extra := what_to_install(error.name)):
        fail(extra)
    if isinstance(error, ImportError):
        return
    if error.errno in _FULL:
        fail(f"{error.filename or 'the output'}: cannot be written: {error.strerror}")
    if error.filename is not None or error.errno == errno.EIO:
        fail(f"{error.filename or 'a file'}: {error.strerror}")


def _lacks_memory(error: Exception) -> bool:
    """True if the system gave no memory, in the words of Python, of the loader, or of a library in C++."""
    return (
        isinstance(error, MemoryError)
        or (isinstance(error, OSError) and error.errno == errno.ENOMEM)
        or (isinstance(error, (RuntimeError, ImportError, OSError)) and _NO_MEMORY.search(str(error)) is not None)
    )


def _stop(*_: object) -> NoReturn:
    """End in order when told to: child programs are ended and temporary folders removed on the way out."""
    signal.signal(signal.SIGTERM, signal.SIG_IGN)  # a second one would cut that short
    fail("stopped", 143)


def fail(message: str, code: int = 1) -> NoReturn:
    """End with one line on stderr."""
    print(f"acoustic-fem: {in_one_line(message)}", file=sys.stderr)
    sys.exit(code)


def _show_warning(
    message: Warning | str,
    category: type[Warning],
    filename: str,
    lineno: int,
    file: TextIO | None = None,
    line: str | None = None,
) -> None:
    print(f"note: {in_one_line(str(message))}", file=sys.stderr)


def _print_version(wanted: bool) -> None:
    if wanted:
        from importlib.metadata import PackageNotFoundError, version

        try:
            commit = _commit()
            print(f"acoustic-fem {version('acoustic-fem')}" + (f" (commit {commit})" if commit else ""))
        except PackageNotFoundError:
            print("acoustic-fem, run from a checkout without an installation")
        raise typer.Exit


def _commit() -> str:
    """The commit of the checkout that runs, with ``-dirty`` where files differ from it; empty for an installation."""
    root = Path(__file__).parents[2]
    if not (root / ".git").exists():
        return ""
    words = ["git", "-C", str(root), "describe", "--always", "--dirty", "--exclude=*"]
    try:
        return subprocess.run(words, capture_output=True, text=True, check=True, timeout=10).stdout.strip()
    except (OSError, subprocess.SubprocessError):
        return ""


@app.callback()
def _root(
    version: Annotated[
        bool,
        typer.Option(
            "--version",
            callback=_print_version,
            is_eager=True,
            help="Print the version, and the commit of a checkout, and stop.",
        ),
    ] = False,
) -> None: ...
