"""What a touch is: events, textures and the user's own kinds, told from reconstructed waveforms.

Stands on: decoders, evaluation, learned, live, recordings, signals.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
