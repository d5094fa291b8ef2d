"""Packages that load libraries of the system: where one is missing their import says in one line what to install."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec, PathFinder
from importlib.util import find_spec
from types import ModuleType

from geometry.refusal import Refusal
from geometry.system.libraries import missing_libraries, what_is_missing

#: The CAD kernel, the mesher and the renderer, by what is loaded of them.
PACKAGES = frozenset({"OCP", "cadquery", "gmsh", "pyvista", "vtkmodules"})


class MissingLibrary(Refusal, ImportError):
    """A library of the system without which nothing can be drawn or meshed is missing; the message names its package.

    It says nothing of a design: a study that meets it ends, and does not keep it as the reason of a case.
    """


def check_system_libraries() -> None:
    """Refuse to draw parts, pictures and meshes, before any work is done for them, where a library is missing.

    Without one of them the renderer ends with a segmentation fault.

    Raises:
        MissingLibrary: with what to install.
    """
    if missing := missing_libraries():
        raise MissingLibrary(what_is_missing(f"{missing[0]}: cannot open shared object file"))


def load_before_renderer() -> None:
    """Load the compiler of PyTorch, where it is installed, before the renderer.

    Where there is no graphics card the renderer loads Mesa's LLVM. Triton brings an LLVM of its own: loaded second, as
    the first optimiser of PyTorch does, it ends the program with a segmentation fault (Debian 12, torch 2.13 for
    CUDA); loaded first, both work.
    """
    if find_spec("triton") is not None:
        importlib.import_module("triton")


def tell_what_is_missing() -> None:
    """Let whoever imports one of the packages know what to install: the one place where that is decided for all."""
    if not any(isinstance(each, _Finder) for each in sys.meta_path):
        sys.meta_path.insert(0, _Finder())


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
            raise MissingLibrary(missing) from error
        raise
