"""What the sensor is: designs, their layout, CAD parts, air volumes and meshes. Lengths in millimetres.

Names are loaded when first used, so that importing the package loads neither the CAD kernel nor gmsh.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from geometry.array_model import build_assembly
    from geometry.assembly import build_parts
    from geometry.bill import bill_of_materials
    from geometry.design import ArrayDesign
    from geometry.design_fields import DesignError
    from geometry.design_file import load_design, prototype, prototype_names, resolve_design, save_design
    from geometry.part_files import export
    from geometry.printing import print_report

_HOME = {
    "ArrayDesign": "geometry.design",
    "DesignError": "geometry.design_fields",
    "bill_of_materials": "geometry.bill",
    "build_assembly": "geometry.array_model",
    "build_parts": "geometry.assembly",
    "export": "geometry.part_files",
    "load_design": "geometry.design_file",
    "print_report": "geometry.printing",
    "prototype": "geometry.design_file",
    "prototype_names": "geometry.design_file",
    "resolve_design": "geometry.design_file",
    "save_design": "geometry.design_file",
}

__all__ = [
    "ArrayDesign",
    "DesignError",
    "bill_of_materials",
    "build_assembly",
    "build_parts",
    "export",
    "load_design",
    "print_report",
    "prototype",
    "prototype_names",
    "resolve_design",
    "save_design",
]


def __getattr__(name: str) -> Any:
    if name not in _HOME:
        raise AttributeError(f"module 'geometry' has no attribute {name!r}")
    value = getattr(import_module(_HOME[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
