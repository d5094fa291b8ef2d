"""Extras of the installation: what needs packages that the core does not bring, and the line to type for them."""

from __future__ import annotations

from importlib.util import find_spec

from geometry.ground.refusal import Kind, Refusal

#: Extra of pyproject.toml: packages by which it is known to be there, as they are imported.
EXTRAS = {
    "plots": ("matplotlib",),
    "cad": ("cadquery", "trimesh", "lib3mf", "manifold3d", "pyvista"),
    "fem": ("gmsh",),
    "onnx": ("onnx", "onnxruntime"),
    "train": ("torch", "safetensors"),
    "studies": ("cloudpickle", "dask", "distributed", "optuna", "plotly", "jinja2", "numcodecs", "zarr"),
    "studio": ("starlette", "uvicorn", "websockets"),
    "live": ("sounddevice",),
    "serial": ("serial",),
    "audio": ("soundfile",),
    "sofa": ("sofar",),
    "parquet": ("pyarrow",),
    "fonts": ("HersheyFonts",),
}
#: Packages that those of an extra bring: theirs is the name in the error where they are missing.
_BROUGHT = {"OCP": "cad", "vtkmodules": "cad"}


class NotInstalled(Refusal, ImportError):
    """Something that is asked for is missing on this machine; the message says what to install.

    It says nothing of a design: a study that meets it ends, and does not keep it as the reason of a case.
    """


class MissingExtra(NotInstalled):
    """Packages that are asked for are not installed; the message is the line to type."""


def check_extras(what: str, *extras: str) -> None:
    """Refuse work, before any is done, whose packages are not installed.

    Args:
        what: needs them, in words.
        extras: names of :data:`EXTRAS`.

    Raises:
        MissingExtra: with what to install.
    """
    missing = [each for each in extras if not is_installed(each)]
    if missing:
        raise MissingExtra(_line(what, ",".join(missing)), kind=Kind.NOT_INSTALLED)


def is_installed(extra: str) -> bool:
    """True where all packages of an extra are installed."""
    return all(find_spec(package) is not None for package in EXTRAS[extra])


def what_to_install(module: str | None) -> str:
    """Line on the extra that brings a module; empty for modules of no extra.

    Args:
        module: full name of the one that was not found.
    """
    package = (module or "").partition(".")[0]
    owner = next((extra for extra, packages in EXTRAS.items() if package in packages), _BROUGHT.get(package))
    return "" if owner is None else _line(f"{package}, which this needs,", owner)


def installed_version(package: str) -> str:
    """Version of a package of an extra.

    Raises:
        MissingExtra: it is not installed.
    """
    from importlib.metadata import PackageNotFoundError, version

    try:
        return version(package)
    except PackageNotFoundError:
        raise MissingExtra(what_to_install(package), kind=Kind.NOT_INSTALLED) from None


def _line(what: str, extras: str) -> str:
    return f"{what} is not installed: pip install 'acoustic-fem[{extras}]'"
