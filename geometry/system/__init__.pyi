from .extras import MissingExtra as MissingExtra, NotInstalled as NotInstalled
from .loading import MissingLibrary as MissingLibrary, check_system_libraries as check_system_libraries
