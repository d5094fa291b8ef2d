"""The rooms depend on each other one way only, and importing them is cheap."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
ROOMS = ["geometry", "acoustic_fem", "localize", "studies"]  # each may import from those before it
HEAVY = {"OCP", "cadquery", "gmsh", "vtk", "vtkmodules", "pyvista", "torch", "skfem", "matplotlib", "trimesh"}
MODULES = [path for room in ROOMS for path in sorted((ROOT / room).rglob("*.py"))]


def imports(path: Path) -> set[str]:
    """Top-level names a module imports, at its top or inside functions."""
    names: set[str] = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            names |= {alias.name.split(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path}: relative import"
            names.add(str(node.module).split(".")[0])
    return names


def imported_rooms(path: Path) -> set[str]:
    """Rooms a module imports from."""
    names = imports(path)
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            names |= {room for room in ROOMS if node.value.startswith(f"{room}.")}  # lazily, by name
    return names & set(ROOMS)


@pytest.mark.parametrize("path", MODULES, ids=lambda path: str(path.relative_to(ROOT)))
def test_a_module_imports_only_from_its_own_room_and_those_before_it(path: Path) -> None:
    room = path.relative_to(ROOT).parts[0]
    allowed = set(ROOMS[: ROOMS.index(room) + 1])
    assert imported_rooms(path) <= allowed


def test_all_rooms_hold_modules() -> None:
    assert {path.relative_to(ROOT).parts[0] for path in MODULES} == set(ROOMS)


@pytest.mark.parametrize("package", ["geometry", "acoustic_fem", "localize", "studies.cli"])
def test_importing_a_package_loads_nothing_heavy(package: str) -> None:
    code = f"import sys, {package}; print(*sorted({HEAVY!r} & set(sys.modules)))"
    result = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True)
    assert result.stdout.split() == []


def test_gmsh_is_known_to_one_module_only() -> None:
    users = [path for path in MODULES if "import gmsh" in path.read_text(encoding="utf-8")]
    assert users == [ROOT / "geometry" / "air" / "mesh.py"]


def test_no_module_is_called_utils() -> None:
    assert not [path for path in MODULES if path.stem in ("utils", "helpers", "common", "misc")]


#: Requirements that other packages import for us.
USED_THROUGH_OTHERS = {
    "lxml",  # trimesh reads 3MF with it
    "meshio",  # skfem.io and pyvista read and write meshes with it
    "onnxscript",  # torch writes ONNX files with it
    "netCDF4",  # the engine with which xarray writes netCDF-4
}
#: Modules that come with a requirement under another name.
COMES_WITH = {
    "lazy_loader": "lazy-loader",
    "skfem": "scikit-fem",
    "OCP": "cadquery",
    "pydantic_core": "pydantic",
    "vtkmodules": "pyvista",
}


def test_what_is_required_is_imported_and_what_is_imported_is_required() -> None:
    """A missing requirement breaks a fresh installation, an unused one makes it slower."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    required = {re.split(r"[<>=; \[]", line)[0] for line in project["dependencies"]}
    imported = set().union(*(imports(path) for path in MODULES)) - set(sys.stdlib_module_names) - set(ROOMS)
    assert {COMES_WITH.get(name, name) for name in imported} == required - USED_THROUGH_OTHERS


def test_every_public_name_of_a_package_exists() -> None:
    code = (
        "import importlib\n"
        f"for package in {ROOMS[:3]!r}:\n"
        "    module = importlib.import_module(package)\n"
        "    assert module.__all__\n"
        "    for name in module.__all__:\n"
        "        assert getattr(module, name) is not None, name\n"
        "    assert set(module.__all__) <= set(dir(module))\n"
    )
    subprocess.run([sys.executable, "-c", code], cwd=ROOT, check=True, timeout=120)


def test_the_contract_names_of_geometry_are_functions_not_modules() -> None:
    code = (
        "import geometry, geometry.formats.part_files, geometry.printing, geometry.assembly\n"
        "from geometry import export, print_report, build_parts\n"
        "assert callable(export) and callable(geometry.export) and callable(print_report) and callable(build_parts)\n"
    )
    subprocess.run([sys.executable, "-c", code], cwd=ROOT, check=True, timeout=120)
