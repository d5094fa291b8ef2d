"""What the faces hand on, and under which name each thing has its entry in the reference."""

from __future__ import annotations

import ast
import importlib
import inspect
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[2]
#: Each may import from those before it.
PACKAGES = ("geometry", "acoustic_fem", "localize", "studies")


@dataclass(frozen=True)
class Face:
    """A package or a room, and the names that its stub hands on."""

    path: str
    """Dotted path."""
    names: dict[str, str]
    """Public name -> dotted path of the module that defines it; rooms are left out."""


@cache
def faces() -> tuple[Face, ...]:
    """The faces of all packages and rooms, packages first."""
    found = []
    for package in PACKAGES:
        stubs = [ROOT / package / "__init__.pyi", *sorted((ROOT / package).glob("*/__init__.pyi"))]
        for stub in stubs:
            path = ".".join(stub.parent.relative_to(ROOT).parts)
            names = {}
            for node in ast.parse(stub.read_text(encoding="utf-8")).body:
                if isinstance(node, ast.ImportFrom) and node.module:
                    module = node.module if node.level == 0 else f"{path}.{node.module}"
                    names |= {alias.asname or alias.name: module for alias in node.names}
            found.append(Face(path, names))
    return tuple(found)


@cache
def definition(module: str, name: str) -> tuple[str, str]:
    """Where a name is defined that a module, or the face that it is taken from, hands on."""
    by_path = {face.path: face for face in faces()}
    if module in by_path:
        return definition(by_path[module].names[name], name)
    source = ROOT.joinpath(*module.split(".")).with_suffix(".py")
    for node in ast.parse(source.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.ImportFrom) and node.module and node.module.split(".")[0] in PACKAGES:
            for alias in node.names:
                if (alias.asname or alias.name) == name:
                    return definition(node.module, alias.name)
    return module, name


@cache
def entries() -> dict[str, str]:
    """Every dotted public name -> the dotted name under which it has its entry.

    A name that a room and its package hand on has its entry in the room.
    """
    first: dict[tuple[str, str], str] = {}
    found = {}
    for face in sorted(faces(), key=lambda face: (-face.path.count("."), PACKAGES.index(face.path.split(".")[0]))):
        for name, module in face.names.items():
            found[f"{face.path}.{name}"] = first.setdefault(definition(module, name), f"{face.path}.{name}")
    return found


def entry_of(text: str) -> str | None:
    """The entry that a dotted name in running text belongs to: its own, or that of the class it is a member of."""
    known = entries()
    parts = text.split(".")
    for depth in range(len(parts), 1, -1):
        if (start := ".".join(parts[:depth])) in known:
            return ".".join([known[start], *parts[depth:]])
    return None


def value_of(face: Face, name: str) -> Any:
    """What a face hands on under a name."""
    return getattr(importlib.import_module(face.path), name)


def kind_of(value: Any) -> str:
    """How Sphinx documents a value: ``class``, ``function`` or ``data``."""
    if inspect.isclass(value):
        return "class"
    return "function" if inspect.isroutine(value) or hasattr(value, "__wrapped__") else "data"
