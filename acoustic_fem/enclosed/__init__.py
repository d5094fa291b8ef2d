"""Air that is enclosed in a sensor: its static pressure, how long it lasts, and vents that release it.

Stands on: duct, membrane, network, quantities.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
