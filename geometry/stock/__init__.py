"""Parts that can be bought, as data: sizes, makers, prices; and the parts that a design takes of them.

Stands on: design, ground, schema.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
