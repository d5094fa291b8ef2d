"""Radii of contacts that are taken, and that of a finger that moves: whoever only names them loads nothing."""

RADII = (0.05, 100.0)
"""Smallest and largest radius of a contact, mm."""
MOVING = 5.0
"""Radius of a contact that moves where none is given, mm: a finger."""
