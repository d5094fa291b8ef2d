"""A search from its study file to its designs; what a sweep or search found: table, page, files.

Stands on: optimization, output, study, sweep.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
