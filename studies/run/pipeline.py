"""The whole chain for one design: parts, transfer functions, localizer, figures, report."""

from __future__ import annotations

import warnings
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

import acoustic_fem
import geometry
import localize
from acoustic_fem import Library
from acoustic_fem.library.exchange import write_library
from acoustic_fem.numerics.disk_cache import CacheWarning
from acoustic_fem.quantities.checks import FrequencyLike, frequency_grid
from acoustic_fem.quantities.fidelity import ONE_DESIGN
from geometry.assembly.model import ArrayModel, put_together
from geometry.assembly.part_list import draw_parts
from geometry.body.reading import Body
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design, write_design
from geometry.formats.part_files import FORMATS, ExportedFile
from geometry.ground.missing_packages import check_system_libraries
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.stated_times import stated_seconds, stated_time, stopped_time
from geometry.ground.typed import Array, PathLike
from geometry.layout.arrangement import lay_out
from geometry.layout.overlaps import buildability_notes
from geometry.layout.placement import ArrayLayout
from geometry.layout.remedies import refuse_unbuildable
from geometry.layout.size import laid_out_size
from geometry.printing.printability import PrintReport
from geometry.schema.print_processes import process_of
from localize import BayesDecoder, TrainingPlan
from localize.decoders.tolerant import tolerant_decoder
from localize.signals.array_response import response_of
from localize.signals.locator import Locator
from localize.signals.stimulus import BAND
from studies.kit.body_files import body_beside
from studies.kit.kit_files import write_kit
from studies.kit.making import ALL_THE_SAME
from studies.metrics.pairs import disagreement, worst_heard
from studies.metrics.separation import Separability, separability
from studies.output import response_figures as draw
from studies.output.display import Display, Report
from studies.output.figure_style import crop_picture
from studies.output.folders import DESIGN, MARK, REPORT, RESULTS, claim_folder, claimed_folder, replaced_folder
from studies.output.frequencies import LIBRARY_FREQUENCIES
from studies.run.file_list import write_file_list
from studies.run.findings import AGREEMENT, write_results
from studies.run.library_files import cell_lines
from studies.run.run_report import write_report
from studies.run.run_result import RunResult
from studies.run.validity import model_validity
from studies.verdict import Drawn, Verdict

if TYPE_CHECKING:
    from localize import Localizer
    from studies.evaluation.headline import Headline

#: Stages: parts, cells, localizer, evaluation, figures.
_STAGES = 5
#: Pixels of the picture of one point, before it is cropped.
POINT_PICTURE = (1600, 700)
#: Held-out touches in all, and at least per point; their seed.
EVALUATION_TOUCHES, LEAST_TOUCHES_PER_POINT = 3000, 40
SEED = 0


def run_design(
    design: DesignLike,
    out: PathLike,
    *,
    display: Display | None = None,
    fidelity: str = ONE_DESIGN,
    frequency: FrequencyLike = LIBRARY_FREQUENCIES,
    plan: TrainingPlan | None = None,
    allow_overlaps: bool = False,
) -> RunResult:
    """Result of the whole chain for one design, written into a folder with ``report.html``.

    Cells that an earlier run solved come from the disk cache. Files are written under another name and then renamed, so
    a run that is killed leaves no incomplete file. ``report.html``, ``results.json`` and the list of all files,
    ``MANIFEST.json``, come last. With ``SOURCE_DATE_EPOCH`` set, runs of one design on one machine write equal bytes.

    Args:
        design: the array: a design, the path of its file, or the name of a prototype; it must have at least two points.
        out: a new or empty folder, or one that an earlier run made.
        display: shows progress.
        fidelity: fidelity of the library, see :func:`acoustic_fem.solve`.
        frequency: (n_freq,) Hz, covering 1 to 100 Hz, or FIRST:LAST:COUNT.
        plan: plan of the localizer's training; by default that of :class:`localize.TrainingPlan`, with which a design
            always gives the same report, however busy the machine is. Its noise is that of the evaluation too.
        allow_overlaps: continue even if parts overlap; the report then lists them.

    Raises:
        Refusal: parts overlap, the folder holds other files, or the design cannot be built, solved or decoded.
        OSError: the folder cannot be written.
    """
    show, source, design = display or Display(), design, _with_points(design)
    body = body_beside(source, design)
    stopped_time()
    check_system_libraries()
    layout = lay_out(design)
    if not allow_overlaps:
        refuse_unbuildable(design, layout, ALL_THE_SAME)
    notes = buildability_notes(design, layout)
    grid = frequency_grid(frequency)
    with claimed_folder(Path(out), "run", MARK):
        return _run(design, layout, Path(out), show, fidelity, grid, plan or TrainingPlan(), notes, body)


def _run(
    design: ArrayDesign,
    layout: ArrayLayout,
    out: Path,
    show: Display,
    fidelity: str,
    grid: Array,
    plan: TrainingPlan,
    notes: tuple[str, ...],
    body: Body | None,
) -> RunResult:
    """The chain for a design that can be built, into a folder that is nobody else's."""
    folder = claim_folder(out, write_design(design.completed()))

    with show.stage("Parts", of=_STAGES) as report:
        model, files, printing, figures = _make_parts(design, layout, folder, report, body)
    library, lumped, limits = _solved(design, grid, fidelity, folder, show)
    distances = separability(library.transfer_function)
    localizer, network, bayes, tolerant = _trained_localizer(library, plan, folder, show)

    difference = None
    if lumped is not None:
        same_grid = library.transfer_function.sel(frequency=lumped.frequency)
        difference = disagreement(lumped.transfer_function, same_grid)
    with show.stage("Figures", of=_STAGES) as report:
        figures = {**figures, **_draw_figures(folder, library, lumped, distances, network, report)}
    result = RunResult(
        design=design,
        folder=folder,
        verdict=Verdict(design, drawn=Drawn((), tuple(each for each in printing.findings if each.verdict == "fail"))),
        created=stated_time(),
        library=library,
        lumped=lumped,
        disagreement=difference,
        separability=distances,
        network=network,
        bayes=bayes,
        tolerant=tolerant,
        training={**localizer.training, "plan": dict(localizer.plan)},
        localizer_provenance=localizer.provenance,
        printing=printing,
        layout=model.layout,
        part_counts=model.parts.counts,
        files=files,
        layout_notes=notes,
        validity=model_validity(design, library.medium, worst_heard(library.transfer_function, BAND[1])[0]),
        warnings=limits,
        figures=figures,
        seconds={stage: stated_seconds(seconds) for stage, seconds in show.seconds.items()},
    )
    write_results(result, folder / "results.json")
    write_report(result, folder / "report.html")
    write_file_list(folder, (MARK, DESIGN, *RESULTS, *REPORT))
    return result


def _with_points(design: ArrayDesign | PathLike) -> ArrayDesign:
    """The design, which must have points to tell apart; an error names its file."""
    found = resolve_design(design)
    if found.point_count < 2:
        raise Refusal(
            kind=Kind.UNSUITABLE,
            file=found.name if isinstance(design, ArrayDesign) else design,
            field="lines.0.points",
            value=found.point_count,
            allowed="at least 2, because run tells points apart",
            remedy="solve and parts take one point",
        )
    return found


def _warnings_of_models(caught: list[warnings.WarningMessage], show: Display) -> tuple[str, ...]:
    """Texts of the warnings about a model's limits, for the report; all warnings are shown to the user."""
    shown = dict.fromkeys((entry.category, str(entry.message)) for entry in caught)
    for _, message in shown:
        show.note(f"note: {message}")
    return tuple(message for category, message in shown if not issubclass(category, CacheWarning))


# -- stages ------------------------------------------------------------------------------------------------
def _make_parts(
    design: ArrayDesign, layout: ArrayLayout, folder: Path, report: Report, body: Body | None
) -> tuple[ArrayModel, tuple[ExportedFile, ...], PrintReport, dict[str, Path]]:
    report("CAD", 0.0)
    model = put_together(design, layout, draw_parts(design, layout))
    with replaced_folder(folder / "parts") as fresh:
        rules = process_of(design.printing)
        kit = write_kit(model, fresh, FORMATS, rules, lambda what, done: report(what, 0.9 * done), body)
        files = tuple(replace(file, path=folder / "parts" / file.path.relative_to(fresh)) for file in kit.files)
    report("pictures", 0.9)
    figures = {
        "array": geometry.pictures.draw_array(
            model, folder / "figures" / "array.png", size=(1600, _picture_height(model))
        ),
        "point": geometry.pictures.draw_point(model, folder / "figures" / "point.png", size=POINT_PICTURE),
    }
    for path in figures.values():
        crop_picture(path)
    return model, files, kit.printing, figures


def _picture_height(model: ArrayModel) -> int:
    """Pixels of a picture 1600 wide in which the array is as large as can be, with room for names."""
    width, depth, _ = laid_out_size(model.design, model.layout)
    return int(np.clip(1600 * (0.15 + depth / width), 500, 1400))


def _solved(
    design: ArrayDesign, grid: Array, fidelity: str, folder: Path, show: Display
) -> tuple[Library, Library | None, tuple[str, ...]]:
    """The library, one of closed forms in the band where that is another, and warnings about the models' limits."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", UserWarning)
        with show.stage("Cells", of=_STAGES) as report:
            library = acoustic_fem.solve(design, grid, fidelity=fidelity, progress=report)
            write_library(library, folder / "library.nc")
        for line in cell_lines(library):
            show.note(line)
        lumped = None
        if fidelity != "lumped":
            inside = (grid >= BAND[0]) & (grid <= BAND[1])
            lumped = acoustic_fem.solve(design, grid[inside], fidelity="lumped")
    return library, lumped, _warnings_of_models(caught, show)


def _trained_localizer(
    library: Library, plan: TrainingPlan, folder: Path, show: Display
) -> tuple[Localizer, Headline, Headline, Headline | None]:
    """The trained localizer, and evaluations of it, the Bayes decoder and the tolerance-aware one."""
    from studies.evaluation.headline import TOLERANT, evaluate_headlines

    with show.stage("Localizer", of=_STAGES) as report:
        report("training", 0.0)
        localizer = localize.train(
            library, plan, lambda p: report(f"epoch {p.epoch} of {p.epochs}: {p.accuracy:.1%}", p.epoch / p.epochs)
        )
        with replaced_folder(folder / "localizer") as fresh:
            localizer.save(fresh)
    with show.stage("Evaluation", of=_STAGES) as report:
        touches = max(LEAST_TOUCHES_PER_POINT, EVALUATION_TOUCHES // library.design.point_count)
        noise = plan.microphone_noise
        locators: dict[str, Locator] = {"network": localizer, "Bayes decoder": BayesDecoder(library, noise)}
        tolerant = tolerant_decoder(library, noise)
        if tolerant is not None:
            locators[TOLERANT] = tolerant
        judged = evaluate_headlines(locators, library, response_of(library), touches, noise, SEED, report)
    return localizer, judged["network"], judged["Bayes decoder"], judged.get(TOLERANT)


def _draw_figures(
    folder: Path,
    library: Library,
    lumped: Library | None,
    distances: Separability,
    network: Headline,
    report: Report,
) -> dict[str, Path]:
    where = folder / "figures"
    report("curves", 0.0)
    drawn = {
        "transfer-functions": draw.draw_transfer_functions(library.transfer_function, where / "transfer-functions.png"),
        "differences": draw.draw_differences(library.transfer_function, where / "differences.png"),
    }
    if lumped is not None:
        same_grid = library.transfer_function.sel(frequency=lumped.frequency)
        drawn["comparison"] = draw.draw_comparison(
            lumped.transfer_function, same_grid, where / "comparison.png", (100 * AGREEMENT[0], AGREEMENT[1])
        )
    report("matrices", 0.6)
    drawn["separability"] = draw.draw_separability(distances, where / "separability.png")
    drawn["confusion"] = draw.draw_confusion(network.confusion, distances.points, where / "confusion.png")
    return drawn
