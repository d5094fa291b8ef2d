"""Which module imports which, read from the text of the code: also in functions, for types alone, and through faces."""

from __future__ import annotations

import ast
from dataclasses import dataclass
from functools import cache
from pathlib import Path

PACKAGES = ("geometry", "acoustic_fem", "localize", "studies")


@cache
def tree_of(text: str) -> ast.Module:
    """A module's syntax, parsed once however many rules read it."""
    return ast.parse(text)


@dataclass(frozen=True, order=True)
class Import:
    """One module that takes something from another."""

    module: str
    target: str
    line: int


_FOUND: dict[tuple[tuple[str, int], ...], list[Import]] = {}


class House:
    """The modules of the packages below a folder, and what the faces of packages and rooms hand on."""

    def __init__(self, root: Path) -> None:
        self.files = {
            ".".join(path.relative_to(root).with_suffix("").parts).removesuffix(".__init__"): path
            for package in PACKAGES
            for path in sorted((root / package).rglob("*.py"))
        }
        self.handed_on: dict[str, dict[str, str]] = {}
        for name, path in self.files.items():
            stub = path.with_suffix(".pyi")
            if path.name == "__init__.py" and stub.exists():
                self.handed_on[name] = _names_of_stub(name, stub)

    def home(self, path: str) -> str | None:
        """The module that a dotted path leads to, through the faces; None where it is not of this house."""
        parts = path.split(".")
        if parts[0] not in PACKAGES:
            return None
        place = parts[0]
        for part in parts[1:]:
            if f"{place}.{part}" in self.files:
                place = f"{place}.{part}"
            elif part in self.handed_on.get(place, {}):
                place = self.handed_on[place][part]
            else:
                break
        return place if place in self.files else None

    def imports(self) -> list[Import]:
        """Every import of one module of the house by another, at whatever place it stands."""
        key = tuple((str(path), path.stat().st_mtime_ns) for path in self.files.values())
        if key not in _FOUND:
            _FOUND[key] = self._imports()
        return _FOUND[key]

    def _imports(self) -> list[Import]:
        return [found for name in self.files for found in self._imports_of(name)]

    def _imports_of(self, module: str) -> list[Import]:
        tree = tree_of(self.files[module].read_text(encoding="utf-8"))
        known: dict[str, str] = {}  # local names of modules, for what is reached by attributes
        paths: list[tuple[str, int]] = []
        for node in ast.walk(tree):
            if isinstance(node, ast.Import):
                for alias in node.names:
                    paths.append((alias.name, node.lineno))
                    first = alias.name.split(".")[0]
                    known[alias.asname or first] = alias.name if alias.asname else first
            elif isinstance(node, ast.ImportFrom):
                base = self._absolute(module, node)
                for alias in node.names:
                    paths.append((f"{base}.{alias.name}", node.lineno))
                    known[alias.asname or alias.name] = f"{base}.{alias.name}"
        for node in ast.walk(tree):
            if isinstance(node, ast.Attribute) and (dotted := _dotted(node)) is not None:
                first, _, rest = dotted.partition(".")
                if first in known:
                    paths.append((f"{known[first]}.{rest}", node.lineno))
        found = {(home, line) for path, line in paths if (home := self.home(path)) is not None}
        faces = {name for name in self.files if name in self.handed_on or name in PACKAGES}
        return [Import(module, home, line) for home, line in sorted(found) if home != module and home not in faces]

    def _absolute(self, module: str, node: ast.ImportFrom) -> str:
        if node.level == 0:
            return node.module or ""
        is_face = self.files[module].name == "__init__.py"
        parts = module.split(".")[: len(module.split(".")) - node.level + is_face]
        return ".".join([*parts, *([node.module] if node.module else [])])


def _names_of_stub(face: str, stub: Path) -> dict[str, str]:
    names = {}
    for node in ast.walk(ast.parse(stub.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and node.module is not None:  # rooms are found as files
            names |= {alias.name: f"{face}.{node.module}" for alias in node.names}
    return names


def _dotted(node: ast.expr) -> str | None:
    if isinstance(node, ast.Name):
        return node.id
    if isinstance(node, ast.Attribute) and (before := _dotted(node.value)) is not None:
        return f"{before}.{node.attr}"
    return None


def room_of(module: str) -> str | None:
    """The room of a module, ``geometry.air``; None for those that stand in a package itself."""
    parts = module.split(".")
    return ".".join(parts[:2]) if len(parts) > 2 else None


def circles(edges: dict[str, set[str]]) -> list[list[str]]:
    """Groups of nodes that reach each other, sorted (Tarjan 1972)."""
    index: dict[str, int] = {}
    low: dict[str, int] = {}
    stack: list[str] = []
    found: list[list[str]] = []

    def visit(node: str) -> None:
        index[node] = low[node] = len(index)
        stack.append(node)
        for target in sorted(edges.get(node, ())):
            if target not in index:
                visit(target)
                low[node] = min(low[node], low[target])
            elif target in stack:
                low[node] = min(low[node], index[target])
        if low[node] == index[node]:
            group = stack[stack.index(node) :]
            del stack[stack.index(node) :]
            if len(group) > 1:
                found.append(sorted(group))

    for node in sorted(edges):
        if node not in index:
            visit(node)
    return found
