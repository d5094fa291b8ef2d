from .decoding import Decoding as Decoding
from .file_contents import FileContent as FileContent, file_content as file_content
from .located_touches import LocatedTouches as LocatedTouches, RecordingResult as RecordingResult
from .opened_model import Model as Model
from .opening import ModelSource as ModelSource, open_library as open_library, open_model as open_model
