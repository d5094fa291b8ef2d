"""Prototypes as solids, drawn once for all tests of a process; nobody changes them."""

from __future__ import annotations

import functools

import geometry
from geometry.assembly.model import ArrayModel, array_model
from geometry.assembly.part_list import PartSet


@functools.cache
def built(name: str) -> PartSet:
    """All parts of a prototype."""
    return geometry.build_parts(geometry.prototype(name))


@functools.cache
def put_together(name: str) -> ArrayModel:
    """A prototype put together."""
    return array_model(geometry.prototype(name), built(name))
