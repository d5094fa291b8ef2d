"""The air of the distinct cells: catalogue, solid, mesh (the only place that knows gmsh).

Stands on: design, ground, layout, schema.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
