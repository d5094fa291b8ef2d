from . import (
    bending as bending,
    cli as cli,
    comparison as comparison,
    datasets as datasets,
    evaluation as evaluation,
    findings as findings,
    inference as inference,
    kit as kit,
    metrics as metrics,
    optimization as optimization,
    output as output,
    panels as panels,
    proposals as proposals,
    run as run,
    scatter as scatter,
    studio as studio,
    study as study,
    sweep as sweep,
    test_rig as test_rig,
    verdict as verdict,
)
from .bending.bending_rig import BendingRig as BendingRig
from .bending.bending_run import BendingStudy as BendingStudy, bending_study as bending_study
from .comparison.compared import Comparison as Comparison
from .comparison.comparing import compare as compare
from .datasets.as_built_arrays import AsBuiltArrays as AsBuiltArrays, as_built as as_built
from .datasets.export import ExportedDataset as ExportedDataset, export_dataset as export_dataset
from .evaluation.localizer_evaluation import evaluate_localizer as evaluate_localizer
from .evaluation.localizer_training import (
    TrainedLocalizer as TrainedLocalizer,
    train_kinds as train_kinds,
    train_localizer as train_localizer,
)
from .findings.reporting import (
    BestDesigns as BestDesigns,
    best_designs as best_designs,
    save_best_design as save_best_design,
    sweep_report as sweep_report,
)
from .findings.searching import Search as Search, optimize as optimize
from .inference.batch_diagnosing import diagnose_batch as diagnose_batch
from .inference.board_recording import RecordedBoard as RecordedBoard, record_board as record_board
from .inference.diagnosed_sensors import BatchDiagnosis as BatchDiagnosis, DiagnosedSensor as DiagnosedSensor
from .inference.diagnosing import diagnose_recording as diagnose_recording
from .inference.embedding import EmbeddedFiles as EmbeddedFiles, embed_decoder as embed_decoder
from .inference.exporting import ExportedDecoder as ExportedDecoder, export_decoder as export_decoder
from .inference.live import LiveInput as LiveInput, LiveSummary as LiveSummary, listen as listen
from .inference.pulse_reading import RecordedPulse as RecordedPulse, read_pulse as read_pulse
from .inference.recognized import (
    RecognizedTouch as RecognizedTouch,
    recognize_recording as recognize_recording,
)
from .inference.recorded import (
    AccelerationFile as AccelerationFile,
    Decoding as Decoding,
    LocatedTouches as LocatedTouches,
    locate_recording as locate_recording,
)
from .inference.tracked import TrackedRecording as TrackedRecording, track_recording as track_recording
from .kit.making import MadeParts as MadeParts, export_parts as export_parts
from .optimization.problem import load_optimization as load_optimization
from .output.display import Display as Display
from .proposals.design_writing import new_design as new_design
from .proposals.proposing import Proposal as Proposal, Proposals as Proposals, propose_designs as propose_designs
from .run.body_fit import fit_design as fit_design
from .run.check import DesignCheck as DesignCheck, check_design as check_design
from .run.file_list import FolderCheck as FolderCheck, verify_run as verify_run
from .run.library_files import convert_library as convert_library, solve_library as solve_library
from .run.pipeline import run_design as run_design
from .run.quality import DesignQuality as DesignQuality
from .run.run_result import RunResult as RunResult
from .run.starting import copy_prototype as copy_prototype
from .run.stock_listing import list_stock as list_stock
from .run.wiring import wiring_table as wiring_table
from .scatter.tolerance_run import ToleranceStudy as ToleranceStudy, tolerance_study as tolerance_study
from .studio.serving import serve_studio as serve_studio
from .study.study import Study as Study, load_study as load_study
from .sweep.plan import Plan as Plan, plan_sweep as plan_sweep
from .sweep.results import Sweep as Sweep, open_sweep as open_sweep
from .sweep.run import run_sweep as run_sweep
from .sweep.summary import Summary as Summary
from .test_rig.calibrating import SensorCalibration as SensorCalibration, calibrate_sensor as calibrate_sensor
from .test_rig.recalibrating import Recalibration as Recalibration, recalibrate as recalibrate
from .test_rig.rig_session import RigSession as RigSession, record_rig as record_rig
from .test_rig.rig_touches import TouchSession as TouchSession
from .test_rig.virtual_rig import HiddenScatter as HiddenScatter, Recorder as Recorder, Rig as Rig
from .verdict.verdict import Verdict as Verdict
