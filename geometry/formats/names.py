"""The formats of part files by name, apart from what writes them: whoever only names them loads nothing."""

FORMATS = ("stl", "step", "3mf")
