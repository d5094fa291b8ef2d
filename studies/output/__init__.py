"""Progress, folders, figure style: what every study writes with.

Stands on: metrics.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
