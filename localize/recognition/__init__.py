"""What a touch is: events, textures, the user's own kinds, and the pulse, read from reconstructed waveforms.

Stands on: contacts, decoders, evaluation, learned, live, recordings, signals.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
