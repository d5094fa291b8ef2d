"""The way from a bare machine to a running project: the check of system libraries, the metadata, the commands."""

from __future__ import annotations

import importlib.util
import subprocess
import sys
import tomllib
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).parents[2]


@pytest.fixture
def packages() -> ModuleType:
    spec = importlib.util.spec_from_file_location("system_packages", ROOT / ".ci" / "system_packages.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.skipif(sys.platform != "linux", reason="other systems' wheels bring their libraries")
def test_a_library_that_cannot_be_loaded_is_a_missing_package(
    packages: ModuleType, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(packages, "LIBRARIES", {"libc.so.6": "libc6", "libnowhere.so.1": "libnowhere1"})
    assert packages.missing_packages() == ["libnowhere1"]


def test_without_rights_the_one_line_to_type_is_printed(
    packages: ModuleType, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(packages, "missing_packages", lambda: ["libgl1", "python3-venv"])
    monkeypatch.setattr(packages.os, "geteuid", lambda: 1000, raising=False)
    monkeypatch.setattr(packages.subprocess, "run", lambda *_, **__: pytest.fail("may not install"))
    assert packages.main() == 1
    line = capsys.readouterr().err.splitlines()[-1].strip()
    assert line == "sudo apt-get install -y --no-install-recommends libgl1 python3-venv"


def test_a_failed_installation_is_shown_and_ends_with_the_line_to_type(
    packages: ModuleType, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(packages, "missing_packages", lambda: ["libgl1"])
    monkeypatch.setattr(packages.os, "geteuid", lambda: 0, raising=False)
    monkeypatch.setattr(packages.shutil, "which", lambda _: "/usr/bin/apt-get")
    failed = subprocess.CompletedProcess(["apt-get"], 100, stdout="E: no network")
    monkeypatch.setattr(packages.subprocess, "run", lambda *_, **__: failed)
    assert packages.main() == 1
    err = capsys.readouterr().err
    assert "E: no network" in err
    assert err.splitlines()[-1].strip() == "apt-get install -y --no-install-recommends libgl1"


def test_an_old_python_is_named(
    packages: ModuleType, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(packages, "OLDEST_PYTHON", (9, 0))
    assert packages.main() == 1
    assert "acoustic-fem needs Python 9.0 or later" in capsys.readouterr().err


def test_everything_in_place_is_silent(
    packages: ModuleType, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(packages, "missing_packages", list)
    assert packages.main() == 0
    assert capsys.readouterr() == ("", "")


def test_the_exact_torch_of_a_checkout_is_one_the_project_allows() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    constraints = (ROOT / "constraints.txt").read_text(encoding="utf-8").split()
    assert "torch==2.13.0" in constraints
    assert "torch>=2.13" in project["optional-dependencies"]["train"]


@pytest.mark.parametrize("target", ["demo", "test"])
def test_the_second_make_installs_nothing(target: str, tmp_path: Path) -> None:
    """With the stamps of a finished installation in place, make plans the run alone."""
    for name in ("Makefile", "pyproject.toml", "constraints.txt"):
        (tmp_path / name).write_bytes((ROOT / name).read_bytes())
    first = subprocess.run(["make", "-n", target], cwd=tmp_path, capture_output=True, text=True, check=True).stdout
    assert "pip install --constraint constraints.txt" in first
    (tmp_path / ".venv").mkdir()
    for stamp in (".created", ".installed", ".installed-dev"):
        (tmp_path / ".venv" / stamp).touch()
    second = subprocess.run(["make", "-n", target], cwd=tmp_path, capture_output=True, text=True, check=True).stdout
    assert "pip" not in second
    assert ("acoustic-fem run array-2x6 --out demo" if target == "demo" else "pytest") in second
