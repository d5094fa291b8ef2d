"""Acoustics of a tactile array, in SI units with time convention exp(+j omega t).

Names are loaded when they are first used, so that ``import acoustic_fem`` costs nothing.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
