from .batch_diagnosing import diagnose_batch as diagnose_batch
from .diagnosed_sensors import BatchDiagnosis as BatchDiagnosis, DiagnosedSensor as DiagnosedSensor
from .diagnosing import diagnose_recording as diagnose_recording
from .embedding import EmbeddedFiles as EmbeddedFiles, embed_decoder as embed_decoder
from .exporting import ExportedDecoder as ExportedDecoder, export_decoder as export_decoder
from .live import LiveInput as LiveInput, LiveSession as LiveSession, LiveSummary as LiveSummary, listen as listen
from .recorded import Decoding as Decoding, LocatedTouches as LocatedTouches, locate_recording as locate_recording
