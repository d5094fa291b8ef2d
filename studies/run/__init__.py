"""One design: checked, solved, its parts, or all through the whole chain, and the report.

Stands on: evaluation, kit, metrics, output, verdict.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
