"""Foundations of all packages: refusals as data, files read with care and written whole, extras, system libraries.

Stands on: nothing.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
