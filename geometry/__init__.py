"""Designs of the sensor, their layout, CAD parts, air volumes and meshes. Lengths in millimetres.

Names are loaded when first used, so that importing the package loads neither the CAD kernel nor gmsh.
"""

import lazy_loader

from geometry.ground.missing_packages import tell_what_is_missing

tell_what_is_missing()
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
