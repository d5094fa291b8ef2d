"""The formats of part files by name, apart from what writes them: whoever only names them loads nothing."""

#: Formats of part files, by the ending of their names.
FORMATS = ("stl", "step", "3mf")
