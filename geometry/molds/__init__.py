"""The mold in which membranes are cast.

Stands on: design, schema, solids.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
