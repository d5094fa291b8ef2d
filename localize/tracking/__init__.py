"""Place of a contact on the surface, between the points too, and the path that it takes.

Stands on: contacts, decoders, live, signals.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
