"""Recordings as files, and transfer functions estimated from them.

Stands on: nothing.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
