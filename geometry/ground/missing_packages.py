"""Packages that are not installed, or whose libraries of the system are missing: importing them says in one line what
to install.
"""

from __future__ import annotations

import importlib
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec, PathFinder
from importlib.util import find_spec
from types import ModuleType

from geometry.ground.extras import MissingExtra, NotInstalled, what_to_install
from geometry.ground.refusal import Kind
from geometry.ground.system_libraries import missing_libraries, what_is_missing

#: The CAD kernel, the mesher and the renderer, by what is loaded of them.
PACKAGES = frozenset({"OCP", "cadquery", "gmsh", "pyvista", "vtkmodules"})
#: Packages whose missing imports are reported with the command to type; others may try whether one is there, and do
#: without it.
_OURS = frozenset({"geometry", "acoustic_fem", "localize", "studies"})
#: Modules of the import system, between an import and its finders.
_BETWEEN = frozenset({"_frozen_importlib", "_frozen_importlib_external", "importlib._bootstrap"})


class MissingLibrary(NotInstalled):
    """A library of the system is missing, needed to draw and mesh; the message names its package."""


def check_system_libraries() -> None:
    """Refuse to draw parts, pictures and meshes, before any work is done for them, where a library is missing.

    Without one of them the renderer ends with a segmentation fault.

    Raises:
        MissingLibrary: with what to install.
    """
    if missing := missing_libraries():
        line = what_is_missing(f"{missing[0]}: cannot open shared object file")
        raise MissingLibrary(line, kind=Kind.NOT_INSTALLED)


def load_before_renderer() -> None:
    """Load the compiler of PyTorch, where it is installed, before the renderer.

    Where there is no graphics card the renderer loads Mesa's LLVM. Triton brings an LLVM of its own: loaded second, as
    the first optimiser of PyTorch does, it ends the program with a segmentation fault (Debian 12, torch 2.13 for
    CUDA); loaded first, both work.
    """
    if find_spec("triton") is not None:
        importlib.import_module("triton")


def tell_what_is_missing() -> None:
    """Let whoever imports a package know what to install: the one place where that is decided for all."""
    if not any(isinstance(each, _Finder) for each in sys.meta_path):
        sys.meta_path.insert(0, _Finder())
        sys.meta_path.append(_LastFinder())


class _Finder(MetaPathFinder):
    """Finds the packages where Python finds them."""

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        if fullname.partition(".")[0] not in PACKAGES:
            return None
        spec = PathFinder.find_spec(fullname, path, target)
        if spec is not None and spec.loader is not None:
            spec.loader = _Loader(spec.loader)
        return spec


class _LastFinder(MetaPathFinder):
    """Is asked for what nobody found, and refuses packages of extras that a module of ours imports."""

    def find_spec(self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None) -> None:
        if path is None and (line := what_to_install(fullname)) and _importer().partition(".")[0] in _OURS:
            raise MissingExtra(line, kind=Kind.NOT_INSTALLED)


def _importer() -> str:
    """Name of the module whose statement imports; another where somebody only looks whether there is a module."""
    frame = sys._getframe(2)
    while frame.f_back is not None and frame.f_globals.get("__name__") in _BETWEEN:
        frame = frame.f_back
    return str(frame.f_globals.get("__name__"))


class _Loader(Loader):
    """Loads a module as its own loader does, and leaves it with that."""

    def __init__(self, own: Loader) -> None:
        self._own = own

    def create_module(self, spec: ModuleSpec) -> ModuleType | None:
        with _told():
            return self._own.create_module(spec)

    def exec_module(self, module: ModuleType) -> None:
        module.__loader__ = self._own
        if module.__spec__ is not None:
            module.__spec__.loader = self._own
        with _told():
            self._own.exec_module(module)


@contextmanager
def _told() -> Iterator[None]:
    try:
        yield
    except (ImportError, OSError) as error:
        if missing := what_is_missing(str(error)):
            raise MissingLibrary(missing, kind=Kind.NOT_INSTALLED) from error
        raise
