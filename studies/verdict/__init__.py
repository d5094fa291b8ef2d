"""Verdict on a design: rules as data, figures, reasons in words, and the change that helps most.

Stands on: metrics, output.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
