"""Plans from lengths alone: ring, area, hand, cylinder, routes, wiring counts.

Stands on: ground, schema.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
