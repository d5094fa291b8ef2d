"""The command line in odd surroundings: terminals of no size, texts that would steer it, too little memory."""

from __future__ import annotations

import ast
import errno
import os
from pathlib import Path

import pytest
from refusals import refused
from rich.console import Console

from geometry import Kind
from geometry.ground.process_messages import ChildError
from geometry.ground.refusal import visible
from studies.cli import app, terminal_tables
from studies.cli.environment import check_environment
from studies.cli.terminal_tables import say, show, table_of

CLI = Path(app.__file__).parent
HIDDEN = ["\x1b[2J", "\x07", "\r", "\x9b8m", "\u202e", "\u2066", "\x7f", "\0", "\udcff", "\x85"]


@pytest.mark.parametrize("size", ["0", "-5", "", "abc", "99999999999", "9" * 5000, "1e3", "٣"])
@pytest.mark.parametrize("name", ["COLUMNS", "LINES", "TERMINAL_WIDTH"])
def test_a_size_that_no_terminal_has_is_passed_over(name: str, size: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(name, size)
    check_environment()
    assert name not in os.environ
    assert Console(force_terminal=True).width > 0


@pytest.mark.parametrize("size", ["1", "80", "10000"])
def test_a_size_of_a_terminal_is_kept(size: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", size)
    check_environment()
    assert Console(force_terminal=True).width == int(size)


@pytest.mark.parametrize("backend", ["nonsense", "qtagg", "module://none", " ", "tkagg"])
def test_the_choice_of_a_window_is_passed_over(backend: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("MPLBACKEND", backend)
    check_environment()
    assert os.environ["MPLBACKEND"] == "agg"


def test_a_time_of_nonsense_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "soon")
    with refused(Kind.OUT_OF_RANGE, "SOURCE_DATE_EPOCH", "soon"):
        check_environment()


@pytest.mark.parametrize("hidden", HIDDEN)
def test_a_text_does_not_steer_the_terminal(hidden: str, capsys: pytest.CaptureFixture[str]) -> None:
    say(f"a{hidden}b")
    table = table_of("name", f"x{hidden}")
    table.add_row(f"a{hidden}b", "one\ntwo")
    show(table)
    told = capsys.readouterr().out
    assert hidden not in told.replace("\r\n", "\n")
    assert told.count(hidden.encode("unicode_escape").decode("ascii")) == 3
    assert visible("one\ttwo\nשלום") == "one\ttwo\nשלום"


def test_nothing_is_printed_but_through_what_escapes_it() -> None:
    """Whoever prints a text of a file as it is would let it steer the terminal."""
    own = {
        "say",
        "tell",
        "fail",
        "_show_warning",
        "_print_version",
        "hear",
        "prototypes",
        "_print_summary",
        "_told",
        "tell_wrapped",
    }
    for path in CLI.glob("*.py"):
        for function in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(function, ast.FunctionDef) and function.name not in own:
                calls = [node.func for node in ast.walk(function) if isinstance(node, ast.Call)]
                assert "print" not in {call.id for call in calls if isinstance(call, ast.Name)}, (path, function.name)
    assert terminal_tables.say is say


LACKS = [
    MemoryError(),
    MemoryError("Unable to allocate 8.00 TiB for an array"),
    OSError(errno.ENOMEM, "Cannot allocate memory"),
    RuntimeError("[enforce fail at alloc_cpu.cpp] DefaultCPUAllocator: not enough memory: you tried"),
    RuntimeError("can't start new thread"),
    RuntimeError("std::bad_alloc"),
    ImportError("libtorch_cpu.so: failed to map segment from shared object"),
    OSError("Can't read data (unable to allocate memory)"),
]


@pytest.mark.parametrize("error", LACKS, ids=str)
def test_a_lack_of_memory_is_one_line(error: Exception, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as ended:
        app._tell(error)
    assert ended.value.code == 1
    assert capsys.readouterr().err.startswith("acoustic-fem: there is not enough memory: ")


@pytest.mark.parametrize(
    "error", [RuntimeError("a mistake"), KeyError("memory"), ValueError("out of memory"), OSError(5, "x")]
)
def test_another_error_is_no_lack_of_memory(error: Exception) -> None:
    assert not app._lacks_memory(error)


def test_a_process_that_the_system_killed_says_why() -> None:
    assert "memory" in str(ChildError.ended("the solver", -9))
    assert "memory" not in str(ChildError.ended("the solver", -11))
