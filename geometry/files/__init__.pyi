from .arrays import read_mat as read_mat, read_npz as read_npz
from .ordinary import library_reads as library_reads, ordinary_file as ordinary_file, read_bytes as read_bytes
from .reading import (
    parse_json as parse_json,
    parse_toml as parse_toml,
    read_text as read_text,
    read_toml as read_toml,
)
from .replacing import check_own_kind as check_own_kind
from .tables import read_csv as read_csv
from .writing import replace_section as replace_section, whole_file as whole_file, write_text as write_text
