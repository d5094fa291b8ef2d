"""Extras of the installation and libraries of the system, and one line where what is needed is not there.

Stands on: nothing.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
