"""A made sensor calibrated and recalibrated; priors, figures and a virtual rig for it.

Stands on: output.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
