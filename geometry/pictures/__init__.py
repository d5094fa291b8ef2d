"""PNG views and the offline viewer.

Stands on: assembly, boards, design, ground, layout, molds, plan, solids.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
