"""What the CAD kernel, the mesher and the renderer need of the system, and one line where it is not there.

Stands on: nothing.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
