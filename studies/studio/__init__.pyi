from .guard import Guard as Guard
from .server import studio_app as studio_app
from .serving import serve_studio as serve_studio
from .workplace import Workplace as Workplace
