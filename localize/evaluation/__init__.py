"""How often a locator is right, and whether what it hears is of its sensor.

Stands on: live, signals.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
