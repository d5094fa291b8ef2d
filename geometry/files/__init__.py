"""Files in, checked before they are read, one reader per kind; whole files out (written beside, then renamed).

Stands on: nothing.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
