from .reading import read_text as read_text
from .writing import replace_section as replace_section, whole_file as whole_file, write_text as write_text
