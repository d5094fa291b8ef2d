"""The house is in order: packages, rooms and modules import one way, and importing them is cheap."""

from __future__ import annotations

import ast
import importlib
import re
import subprocess
import sys
import tomllib
from collections.abc import Callable
from pathlib import Path

import house_rules
import pytest
from imports import PACKAGES, House, tree_of

ROOT = Path(__file__).parents[2]
HEAVY = {"OCP", "cadquery", "gmsh", "vtk", "vtkmodules", "pyvista", "torch", "skfem", "matplotlib", "trimesh"}
MODULES = [path for package in PACKAGES for path in sorted((ROOT / package).rglob("*.py"))]
Rule = Callable[[Path], list[str]]


# -- the house as it stands ---------------------------------------------------------------------------
@pytest.mark.parametrize("rule", house_rules.RULES, ids=lambda rule: rule.__name__)
def test_the_house_keeps_the_rule(rule: Rule) -> None:
    assert rule(ROOT) == []


def test_the_page_is_that_of_the_faces() -> None:
    architecture = house_rules.architecture()
    page = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    assert page == architecture.architecture_page(), "python docs/make_architecture.py"
    table = architecture.room_table(architecture.read_rooms(), "geometry")
    assert "| `ground` | " in table
    assert "| `layout` | " in table


# -- a house with one fault each ----------------------------------------------------------------------
#: A sound house: two packages, three rooms, faces, imports that run one way.
SOUND = {
    "geometry/__init__.py": '"""Face."""\n',
    "geometry/__init__.pyi": "from . import ground as ground, upper as upper\nfrom .ground.stone import Stone\n",
    "geometry/ground/__init__.py": '"""Ground.\n\nStands on: nothing.\n"""\n',
    "geometry/ground/__init__.pyi": "from .stone import Stone as Stone\n",
    "geometry/ground/stone.py": "class Stone: ...\n",
    "geometry/ground/sand.py": "from geometry.ground.stone import Stone\n",
    "geometry/upper/__init__.py": '"""Upper.\n\nStands on: ground.\n"""\n',
    "geometry/upper/__init__.pyi": "from .wall import Wall as Wall\n",
    "geometry/upper/wall.py": "from geometry.ground import Stone\n\nclass Wall(Stone): ...\n",
    "acoustic_fem/__init__.py": '"""Face."""\n',
    "acoustic_fem/__init__.pyi": "from . import air as air\n",
    "acoustic_fem/air/__init__.py": '"""Air.\n\nStands on: nothing.\n"""\n',
    "acoustic_fem/air/__init__.pyi": "from .wind import breeze as breeze\n",
    "acoustic_fem/air/wind.py": "import geometry\n\ndef breeze(): return geometry.upper.Wall()\n",
}
FAULTS: dict[str, tuple[Rule, dict[str, str], str]] = {
    "a later package": (
        house_rules.package_order,
        {"geometry/ground/sand.py": "from acoustic_fem.air.wind import breeze\n"},
        "geometry.ground.sand:1 imports acoustic_fem.air.wind of a later package",
    ),
    "a later package, inside a function": (
        house_rules.package_order,
        {"geometry/ground/sand.py": "def f():\n    from acoustic_fem.air import breeze\n    return breeze\n"},
        "geometry.ground.sand:2 imports acoustic_fem.air.wind of a later package",
    ),
    "an upper room, at the top": (
        house_rules.room_order,
        {"geometry/ground/sand.py": "from geometry.upper.wall import Wall\n"},
        "geometry.ground.sand:1 imports geometry.upper.wall: geometry.ground does not stand on upper",
    ),
    "an upper room, inside a function": (
        house_rules.room_order,
        {"geometry/ground/sand.py": "def f():\n    import geometry.upper.wall\n"},
        "geometry.ground.sand:2 imports geometry.upper.wall: geometry.ground does not stand on upper",
    ),
    "an upper room, for types alone": (
        house_rules.room_order,
        {
            "geometry/ground/sand.py": "from typing import TYPE_CHECKING\n\n"
            "if TYPE_CHECKING:\n    from geometry.upper import Wall\n"
        },
        "geometry.ground.sand:4 imports geometry.upper.wall: geometry.ground does not stand on upper",
    ),
    "an upper room, through the package's face": (
        house_rules.room_order,
        {"geometry/ground/sand.py": "import geometry\n\ndef f():\n    return geometry.upper.Wall()\n"},
        "geometry.ground.sand:4 imports geometry.upper.wall: geometry.ground does not stand on upper",
    ),
    "an upper room, by a relative import": (
        house_rules.room_order,
        {"geometry/ground/sand.py": "from ..upper import wall\n"},
        "geometry.ground.sand:1 imports geometry.upper.wall: geometry.ground does not stand on upper",
    ),
    "a room it does not need": (
        house_rules.room_order,
        {"geometry/upper/wall.py": "class Wall: ...\n"},
        "geometry.upper says it stands on ground and imports nothing of it",
    ),
    "two modules in a circle": (
        house_rules.module_circles,
        {"geometry/ground/stone.py": "def f():\n    from geometry.ground import sand\n    return sand\n"},
        "a circle: geometry.ground.sand - geometry.ground.stone",
    ),
    "a file name that stands twice": (
        house_rules.rooms_and_modules,
        {"acoustic_fem/air/stone.py": ""},
        "one file name twice: geometry.ground.stone, acoustic_fem.air.stone",
    ),
    "a module in no room": (
        house_rules.rooms_and_modules,
        {"geometry/stray.py": ""},
        "geometry.stray stands in no room",
    ),
    "a name that says nothing": (
        house_rules.rooms_and_modules,
        {"geometry/ground/utils.py": ""},
        "geometry.ground.utils: a name that says nothing",
    ),
    "a room of a public function's name": (
        house_rules.names_at_the_doors,
        {"geometry/__init__.pyi": "from .ground.stone import upper as upper\n"},
        "geometry.upper is public and a room",
    ),
    "a module of its function's name": (
        house_rules.names_at_the_doors,
        {"acoustic_fem/air/__init__.pyi": "from .wind import wind as wind\n"},
        "acoustic_fem.air.wind is public and a module",
    ),
    "an argument of another name": (
        house_rules.one_form_of_arguments,
        {"acoustic_fem/air/wind.py": "def breeze(medium): ...\n"},
        "acoustic_fem.air.breeze(medium=) is called air elsewhere",
    ),
    "a grid that takes no text": (
        house_rules.one_form_of_arguments,
        {
            "geometry/upper/wall.py": "from geometry.ground import Stone\n\nclass Wall(Stone):\n"
            "    def sound(self, frequency: ArrayLike): ...\n"
        },
        "geometry.upper.Wall.sound(frequency: ArrayLike) is FrequencyLike elsewhere",
    ),
    "an air of another type": (
        house_rules.one_form_of_arguments,
        {"acoustic_fem/air/wind.py": "def breeze(*, air: Medium = None): ...\n"},
        "acoustic_fem.air.breeze(air: Medium) is AirLike elsewhere",
    ),
    "another default": (
        house_rules.one_form_of_arguments,
        {"acoustic_fem/air/wind.py": "def breeze(microphone_noise: float = 1e-3): ...\n"},
        "acoustic_fem.air.breeze(microphone_noise=0.001) has the default 'design' elsewhere",
    ),
}


def build(root: Path, files: dict[str, str]) -> Path:
    for name, text in files.items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return root


@pytest.mark.parametrize("rule", house_rules.RULES, ids=lambda rule: rule.__name__)
def test_a_sound_house_has_nothing_to_mend(rule: Rule, tmp_path: Path) -> None:
    assert rule(build(tmp_path, SOUND)) == []


@pytest.mark.parametrize("fault", FAULTS)
def test_a_planted_fault_is_found(fault: str, tmp_path: Path) -> None:
    rule, files, message = FAULTS[fault]
    assert message in rule(build(tmp_path, {**SOUND, **files}))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("Ground.", "does not say which rooms it stands on"),
        ("Ground.\n\nStands on: upper.", "stand on each other in a circle"),
        ("Ground.\n\nStands on: cellar.", "or on none that there is"),
    ],
)
def test_a_face_that_does_not_fit_the_house_is_refused(text: str, message: str, tmp_path: Path) -> None:
    build(tmp_path, {**SOUND, "geometry/ground/__init__.py": f'"""{text}\n"""\n'})
    with pytest.raises(ValueError, match=message):
        house_rules.architecture().read_rooms(tmp_path)


# -- imports are cheap --------------------------------------------------------------------------------
@pytest.mark.parametrize("package", ["geometry", "acoustic_fem", "localize", "studies", "studies.cli.app"])
def test_importing_a_package_loads_nothing_heavy(package: str) -> None:
    code = f"import sys, {package}; print(*sorted({HEAVY!r} & set(sys.modules)))"
    result = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True)
    assert result.stdout.split() == []


def test_the_server_of_the_studio_starts_without_what_only_its_processes_need() -> None:
    code = f"import sys, studies.studio.server; print(*sorted({HEAVY!r} & set(sys.modules)))"
    result = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True)
    assert set(result.stdout.split()) <= {"skfem"}  # its curves come from the atlas


def test_every_name_of_every_face_exists() -> None:
    for face in sorted(House(ROOT).handed_on):
        module = importlib.import_module(face)
        assert module.__all__, face
        for name in module.__all__:
            assert getattr(module, name) is not None, (face, name)
        assert set(module.__all__) <= set(dir(module)), face


# -- modules and requirements -------------------------------------------------------------------------
def imported_names(path: Path) -> set[str]:
    """Top-level names a module imports, at its top or inside functions."""
    names: set[str] = set()
    for node in ast.walk(tree_of(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            names |= {alias.name.split(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            names.add(str(node.module).split(".")[0])
    return names


def test_gmsh_is_known_to_one_module_only() -> None:
    assert [path for path in MODULES if "gmsh" in imported_names(path)] == [ROOT / "geometry" / "air" / "mesh.py"]


def test_no_module_of_ours_is_loaded_by_a_path_in_a_string() -> None:
    """Where an import can be, a move of the module would break the string unseen."""
    ours = re.compile(rf"(?:{'|'.join(PACKAGES)})(?:\.\w+)*")
    found = []
    for path in MODULES:
        for node in ast.walk(tree_of(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and ast.unparse(node.func).split(".")[-1] in {"import_module", "files"}:
                found += [f"{path}: {ast.unparse(node)}" for each in node.args if is_text(each, ours)]
            if isinstance(node, ast.List | ast.Tuple) and any(is_text(each, re.compile("-m")) for each in node.elts):
                found += [f"{path}: {ast.unparse(node)}" for each in node.elts if is_text(each, ours)]
    assert found == []


def is_text(node: ast.expr, pattern: re.Pattern[str]) -> bool:
    return isinstance(node, ast.Constant) and isinstance(node.value, str) and pattern.fullmatch(node.value) is not None


#: Requirements that other packages import for us.
USED_THROUGH_OTHERS = {
    "lxml",  # trimesh reads 3MF with it
    "meshio",  # skfem.io and pyvista read and write meshes with it
    "onnxscript",  # torch writes ONNX files with it
    "websockets",  # uvicorn speaks with the studio's page by it
}
#: Modules that come with a requirement under another name.
COMES_WITH = {
    "HersheyFonts": "Hershey-Fonts",
    "lazy_loader": "lazy-loader",
    "skfem": "scikit-fem",
    "OCP": "cadquery",
    "pydantic_core": "pydantic",
    "vtkmodules": "pyvista",
}


def names_of(requirements: list[str]) -> set[str]:
    return {re.split(r"[<>=; \[]", line)[0] for line in requirements}


def imported_by(modules: list[Path]) -> set[str]:
    """Requirements that modules import."""
    names = set().union(*(imported_names(path) for path in modules)) - set(sys.stdlib_module_names) - {*PACKAGES}
    return {COMES_WITH.get(name, name) for name in names}


def test_what_is_required_is_imported_and_what_is_imported_is_required() -> None:
    """A missing requirement breaks a fresh installation, an unused one makes it slower."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    extras = {name: names_of(lines) - {"acoustic-fem"} for name, lines in project["optional-dependencies"].items()}
    required = names_of(project["dependencies"]).union(
        *(
            extras[name]
            for name in ("audio", "plots", "cad", "fem", "onnx", "train", "studies", "sofa", "parquet", "fonts")
        )
    )
    optional = extras["studio"]
    studio = ROOT / "studies" / "studio"
    everywhere = imported_by([path for path in MODULES if not path.is_relative_to(studio)])
    assert everywhere == required - USED_THROUGH_OTHERS
    in_the_studio = imported_by([path for path in MODULES if path.is_relative_to(studio)])
    assert in_the_studio - everywhere == optional - USED_THROUGH_OTHERS


def test_errors_that_are_raised_on_purpose_are_refusals() -> None:
    """The command line tells a user's error from ours by the class: every ValueError of ours is a Refusal."""
    found = [
        f"{path}:{node.lineno}"
        for path in MODULES
        for node in ast.walk(tree_of(path.read_text(encoding="utf-8")))
        if (isinstance(node, ast.Raise) and node.exc is not None and ast.unparse(node.exc).startswith("ValueError"))
        or (isinstance(node, ast.ClassDef) and node.name != "Refusal" and "ValueError" in map(ast.unparse, node.bases))
    ]
    assert found == []
