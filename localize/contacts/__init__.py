"""Contacts that move over an array: what presses where and how hard, what the microphones hear, and kinds of them.

Stands on: signals.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
