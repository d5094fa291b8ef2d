"""Arrays that data sets are drawn from, and data sets as files for programs of others.

Stands on: output, sweep.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
