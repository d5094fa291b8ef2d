"""Ports joined: the array at any fidelity; the microphone as its load.

Stands on: cavity, duct, membrane, quantities.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
