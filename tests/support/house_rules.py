"""The rules of the house, each as a function from a tree of files to what breaks it, one line each."""

from __future__ import annotations

import ast
import importlib.util
import sys
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

from imports import PACKAGES, House, circles, room_of, tree_of

ROOT = Path(__file__).resolve().parents[2]
#: Names that say nothing of what lives there.
EMPTY_NAMES = {"utils", "util", "helpers", "common", "misc", "tools"}


def architecture() -> ModuleType:
    """The script that reads the table of rooms and writes the page."""
    spec = importlib.util.spec_from_file_location("make_architecture", ROOT / "docs" / "make_architecture.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


def package_order(root: Path) -> list[str]:
    """Imports of a package that comes later."""
    return [
        f"{one.module}:{one.line} imports {one.target} of a later package"
        for one in House(root).imports()
        if PACKAGES.index(one.target.split(".")[0]) > PACKAGES.index(one.module.split(".")[0])
    ]


def room_order(root: Path) -> list[str]:
    """Imports of a room that the face does not name, and rooms named that nothing is imported from."""
    rooms = {room.path: room for room in architecture().read_rooms(root)}
    used = defaultdict(set)
    broken = []
    for one in House(root).imports():
        here, there = room_of(one.module), room_of(one.target)
        if here is None or there is None or here == there or here.split(".")[0] != there.split(".")[0]:
            continue
        name = there.split(".")[1]
        used[here].add(name)
        if here in rooms and name not in rooms[here].stands_on:
            broken.append(f"{one.module}:{one.line} imports {one.target}: {here} does not stand on {name}")
    idle = [
        f"{path} says it stands on {name} and imports nothing of it"
        for path, room in rooms.items()
        for name in room.stands_on
        if name not in used[path]
    ]
    return broken + idle


def module_circles(root: Path) -> list[str]:
    """Modules that import each other, at any place."""
    edges = defaultdict(set)
    for one in House(root).imports():
        edges[one.module].add(one.target)
    return [f"a circle: {' - '.join(group)}" for group in circles(edges)]


def rooms_and_modules(root: Path) -> list[str]:
    """Modules in no room, file names that stand twice, and names that say nothing."""
    modules = [name for name, path in House(root).files.items() if path.name != "__init__.py"]
    places: dict[str, list[str]] = defaultdict(list)
    broken = []
    for name in modules:
        if name.rsplit(".", 1)[1] == "__main__":
            continue
        places[name.rsplit(".", 1)[1]].append(name)
        if room_of(name) is None:
            broken.append(f"{name} stands in no room")
        if EMPTY_NAMES & {*name.split(".")}:
            broken.append(f"{name}: a name that says nothing")
        if name.count(".") > 2:
            broken.append(f"{name}: a room within a room")
    return broken + [f"one file name twice: {', '.join(found)}" for found in places.values() if len(found) > 1]


def names_at_the_doors(root: Path) -> list[str]:
    """Names of faces that a room or module of the same place would hide."""
    house = House(root)
    broken = []
    for face, names in house.handed_on.items():
        beside = {name.rsplit(".", 1)[1] for name in house.files if name.rpartition(".")[0] == face}
        broken += [
            f"{face}.{name} is public and a {'room' if face in PACKAGES else 'module'}"
            for name in names
            if name in beside
        ]
    return broken


#: Names that an argument at a face has elsewhere, and the packages in which it must not have them.
OTHER_NAMES = {
    "medium": ("air", PACKAGES),
    "frequencies": ("frequency", PACKAGES),
    "noise": ("microphone_noise", PACKAGES),
    "radius": ("contact_radius_mm", ("localize", "studies")),
    "contact_radius": ("contact_radius_mm", ("geometry", "localize", "studies")),
    "contact_radius_mm": ("contact_radius", ("acoustic_fem",)),
}
#: Types that an argument has wherever it is taken. An array is a grid that belongs to other arrays, a float one value.
TYPES = {
    "frequency": (
        "FrequencyLike",
        "FrequencyLike | None",
        "Array",
        "Values",
        "NumpyOrTorch",
        "NDArray[np.float64]",
        "float",
    ),
    "air": ("AirLike", "LocalAir | None", "AirLike | MediumParameters"),
}
#: Defaults that an argument has wherever it has one.
DEFAULTS = {"microphone_noise": ("'design'", "None"), "air": ("None",)}


def one_form_of_arguments(root: Path) -> list[str]:
    """Arguments of public functions, methods and classes whose name, type or default differs from that elsewhere."""
    broken = []
    for name, given, default in _arguments_at_the_doors(House(root)):
        package, annotation = name.split(".")[0], "" if given.annotation is None else ast.unparse(given.annotation)
        other, packages = OTHER_NAMES.get(given.arg, ("", ()))
        if package in packages:
            broken.append(f"{name}({given.arg}=) is called {other} elsewhere")
        if given.arg in TYPES and annotation not in TYPES[given.arg]:
            broken.append(f"{name}({given.arg}: {annotation}) is {TYPES[given.arg][0]} elsewhere")
        if default is not None and given.arg in DEFAULTS and ast.unparse(default) not in DEFAULTS[given.arg]:
            broken.append(
                f"{name}({given.arg}={ast.unparse(default)}) has the default {DEFAULTS[given.arg][0]} elsewhere"
            )
    return sorted(set(broken))


def _arguments_at_the_doors(house: House) -> Iterator[tuple[str, ast.arg, ast.expr | None]]:
    """Arguments of what faces hand on, by the dotted name of the function or class, each with its default."""
    for face, names in house.handed_on.items():
        for name, module in names.items():
            if module not in house.files:
                continue
            for node in tree_of(house.files[module].read_text(encoding="utf-8")).body:
                if isinstance(node, ast.FunctionDef) and node.name == name:
                    yield from _arguments(f"{face}.{name}", node.args)
                elif isinstance(node, ast.ClassDef) and node.name == name:
                    for part in node.body:
                        if isinstance(part, ast.FunctionDef) and (part.name == "__init__" or part.name[0] != "_"):
                            yield from _arguments(f"{face}.{name}.{part.name}", part.args)


def _arguments(name: str, given: ast.arguments) -> Iterator[tuple[str, ast.arg, ast.expr | None]]:
    placed = [*given.posonlyargs, *given.args]
    defaults = [*[None] * (len(placed) - len(given.defaults)), *given.defaults]
    for argument, default in [
        *zip(placed, defaults, strict=True),
        *zip(given.kwonlyargs, given.kw_defaults, strict=True),
    ]:
        yield name, argument, default


RULES = (package_order, room_order, module_circles, rooms_and_modules, names_at_the_doors, one_form_of_arguments)
