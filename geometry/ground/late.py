"""Functions of rooms above, for methods by which an object draws or writes itself.

A design is drawn by a room that stands on designs, so the room of designs cannot import it. Such a method is a door
for the user alone: it names the function, which is loaded when the method is called. Nothing else may use this.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any


def function_above(module: str, name: str) -> Any:
    """Function of a module that stands on the caller's.

    Args:
        module: dotted name of the module.
        name: of the function.
    """
    return getattr(import_module(module), name)
