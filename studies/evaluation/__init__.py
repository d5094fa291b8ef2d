"""A localizer trained and evaluated, also under other conditions, and its report.

Stands on: output, test_rig.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
