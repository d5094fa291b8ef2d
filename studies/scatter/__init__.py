"""Manufacturing tolerances, what they do, and the study of it.

Stands on: metrics, output.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
