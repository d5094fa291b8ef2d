"""Kinds of touch: events, textures, the user's own kinds, the pulse, and letters that are written on an array.

Stands on: contacts, decoders, graphs, learned, live, recordings, signals, tracking.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
