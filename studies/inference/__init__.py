"""A localizer put to work: on a recording, on live input, as a graph or as C for others.

Stands on: output.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
