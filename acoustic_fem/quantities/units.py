"""Millimetres and megapascals of :mod:`geometry` to SI: the one place that converts."""

from __future__ import annotations


def metres(millimetres: float) -> float:
    """Length in m from millimetres, mm."""
    return millimetres * 1e-3


def cubic_metres(cubic_millimetres: float) -> float:
    """Volume in m^3 from cubic millimetres, mm^3."""
    return cubic_millimetres * 1e-9


def pascals(megapascals: float) -> float:
    """Modulus in Pa from megapascals, MPa."""
    return megapascals * 1e6
