"""Parts of a study: file, cases, constraints, metrics by name.

Stands on: metrics, scatter, verdict.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
