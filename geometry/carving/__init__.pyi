from .carved_bodies import CarvedBodies as CarvedBodies, CarvedBody as CarvedBody, carve as carve
