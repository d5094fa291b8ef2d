"""Can it be printed: measures, rules, pose, plates, report.

Stands on: assembly, design, formats, ground, molds, schema, solids.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
