"""Circuit board of a microphone: planned from the design, checked, drawn, written as KiCad and Gerber files.

Stands on: design, ground, schema, solids, stock.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
