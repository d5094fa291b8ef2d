"""One door to a model: a network, a graph or the decoder of a library, opened once with all that it needs.

Stands on: decoders, evaluation, graphs, learned, live, recordings, signals, tracking, two_touches.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
