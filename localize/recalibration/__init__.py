"""The library brought to the sensor from unlabelled touches.

Stands on: decoders, evaluation, live, signals.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
