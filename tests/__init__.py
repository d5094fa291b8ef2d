"""A package, so that the one of the same name that some distributions install does not hide it."""
