"""The calls of a designer: whatever a verb of the command line does, with the same defaults and files.

Names are loaded when they are first used, so that ``import studies`` loads nothing heavy. No room may bear the name of
one of them: importing it would hide the function.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
