"""Two or three touches at once, each the stroke of a membrane.

Stands on: decoders, live, signals.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
