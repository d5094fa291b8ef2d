"""The studio: a page on this machine that shows what a change of a design does, and the server behind it.

Stands on: comparison, panels.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
