"""From microphone signals to the touched point.

Names are loaded when they are first used, so that ``import localize`` does not load torch. No module may bear the
name of one of them: importing it would hide the function.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
