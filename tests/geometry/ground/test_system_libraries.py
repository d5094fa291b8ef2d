"""A library of the system that is missing is one line that says what to install."""

from __future__ import annotations

import sys

import pytest

from geometry.ground import system_libraries
from geometry.ground.missing_packages import check_system_libraries
from geometry.ground.refusal import Refusal
from studies.cli import app

GL = "libGL.so.1: cannot open shared object file: No such file or directory"


@pytest.fixture(autouse=True)
def _a_system_without_them(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(system_libraries, "_can_load", lambda name: name not in ("libGL.so.1", "libEGL.so.1"))


@pytest.mark.parametrize("error", [ImportError(GL), OSError(GL)], ids=["cadquery", "gmsh"])
def test_a_module_that_cannot_be_loaded_is_one_line(
    error: Exception, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def loading(*_: object, **__: object) -> None:
        raise error

    monkeypatch.setattr(app, "app", loading)
    monkeypatch.setattr(sys, "argv", ["acoustic-fem"])
    with pytest.raises(SystemExit) as ended:
        app.main()
    assert ended.value.code == 1
    assert capsys.readouterr().err == (
        "acoustic-fem: libGL.so.1: this library of the system is missing; on Debian and Ubuntu type: "
        "sudo apt-get install -y --no-install-recommends libgl1 libegl1\n"
    )


@pytest.mark.skipif(sys.platform != "linux", reason="other systems' wheels bring their libraries")
def test_drawing_is_refused_where_child_programs_and_the_renderer_would_crash() -> None:
    with pytest.raises(Refusal, match=r"^libEGL\.so\.1: this library .* libegl1 libgl1$"):
        check_system_libraries()


@pytest.mark.parametrize("message", ["No module named 'studies.nowhere'", "cannot import name 'x' from 'y'", ""])
def test_mistakes_of_the_program_are_none_of_these(message: str) -> None:
    assert system_libraries.what_is_missing(message) == ""


def test_a_library_without_a_known_package_is_named() -> None:
    said = system_libraries.what_is_missing("libxyz.so.3: cannot open shared object file: No such file or directory")
    assert said == "libxyz.so.3: this library of the system is missing; install the package that holds it"
