"""What all stands on: refusals as data, files read with care and written whole, extras and libraries of the system.

Stands on: nothing.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
