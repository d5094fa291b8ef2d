"""What is made of a body to carry an array: the body with pockets, a skin, a drilling template, and their clash test.

Stands on: assembly, body, design, ground, layout, plan, schema,
solids.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
