"""The network: features, training, files, graphs.

Stands on: decoders, graphs, layers, live, recordings, signals.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
