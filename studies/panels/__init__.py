"""Contents of the studio's panels for a design: its form, its figures and its files, by the calls of Python.

Stands on: comparison, findings, inference, kit, metrics, optimization, output, proposals, run, study, sweep,
verdict.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
