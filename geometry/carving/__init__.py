"""A body made to carry an array: pockets cut into it, a skin, a drilling template, and the clash test of all parts.

Stands on: assembly, body, design, ground, layout, plan, schema,
solids.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
