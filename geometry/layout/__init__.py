"""Positions of all shells, tubes and microphones of one design; overlaps; the cutting list.

Stands on: design, ground, plan, schema.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
