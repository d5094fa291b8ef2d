"""All parts of an array: which, how many, where; bill and fit.

Stands on: boards, design, ground, layout, molds, plan, schema, solids, stock.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
