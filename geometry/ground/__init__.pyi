from .array_files import read_mat as read_mat, read_npz as read_npz
from .caller_warnings import warn_caller as warn_caller
from .csv_files import read_csv as read_csv
from .extras import MissingExtra as MissingExtra, NotInstalled as NotInstalled
from .file_checks import (
    check_local as check_local,
    library_reads as library_reads,
    ordinary_file as ordinary_file,
    read_bytes as read_bytes,
)
from .missing_packages import MissingLibrary as MissingLibrary, check_system_libraries as check_system_libraries
from .refusal import Field as Field, Kind as Kind, Refusal as Refusal
from .text_files import (
    parse_json as parse_json,
    parse_toml as parse_toml,
    read_text as read_text,
    read_toml as read_toml,
)
from .whole_files import (
    check_own_kind as check_own_kind,
    leftovers as leftovers,
    made_folder as made_folder,
    replace_section as replace_section,
    whole_file as whole_file,
    write_text as write_text,
)
