"""Arrays laid on a body: even places, the order of each line, ports, microphones, and the frozen result.

Stands on: body, design, ground, layout, plan, schema.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
