"""A designer's question and the designs that answer it: layouts, stock parts, search, and what would work instead.

Stands on: metrics, output, verdict.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
