"""A search from its study file to its files."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from geometry.ground.missing_packages import check_system_libraries
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.shown import Shown
from geometry.ground.typed import PathLike
from geometry.ground.whole_files import writing
from studies.findings.search_files import save_search, unprintable_designs
from studies.optimization.journal import JOURNAL, seal
from studies.optimization.problem import Optimization, load_optimization
from studies.optimization.search import OptimizationResult, search_designs, without
from studies.output.display import Display
from studies.output.folders import check_folder, claimed_folder


@dataclass(frozen=True, eq=False, repr=False)
class Search(Shown):
    """Results of a search, and their files."""

    problem: Optimization
    """Problem: what is wanted of the designs."""
    result: OptimizationResult
    """Designs computed, and those on the front, whose parts are drawn and pass the print rules."""
    files: tuple[Path, ...]
    """Files that were written, most wanted first."""

    def shown(self) -> tuple[str, Mapping[str, object]]:
        """Title and facts that a session and a notebook show."""
        best = self.result.front[0] if self.result.front else None
        wanted = ", ".join(f"{each.metric.name} {each.better}" for each in self.problem.objectives)
        return f"Search {self.problem.study.name}", {
            "wanted": wanted,
            "designs": f"{len(self.result.candidates)} computed, {len(self.result.front)} on the front",
            "best": "" if best is None else ", ".join(f"{name} {value:.4g}" for name, value in best.metrics.items()),
            "with": "" if best is None else ", ".join(f"{name} {value}" for name, value in best.values.items()),
            "files": ", ".join(str(path) for path in self.files),
        }


def optimize(
    study: Optimization | PathLike,
    out: PathLike,
    *,
    workers: int | None = None,
    scheduler: str | None = None,
    display: Display | None = None,
) -> Search:
    """Best designs of a study that can be printed and laid out.

    If the search is killed, call it again: it continues where it stopped. To continue a finished search, give the study
    more trials.

    Args:
        study: a study file with a section ``[optimize]``, or an optimization that was read from one.
        out: a new folder, or the folder of this search, which is then continued.
        workers: number of processes on this machine; 1 computes in this process; by default one per core.
        scheduler: address of a dask scheduler whose workers are used instead.
        display: shows progress.

    Raises:
        Refusal: a study that cannot be read, a folder that holds other files or another search, or to which a search is
            writing; or no design that meets the limits and can be printed.
    """
    folder, show = Path(out), display or Display()
    problem = study if isinstance(study, Optimization) else load_optimization(study)
    check_folder(folder, "search", JOURNAL)
    check_system_libraries()  # at the end of the search its best designs are drawn
    with claimed_folder(folder, "search", JOURNAL), writing(folder / JOURNAL):
        with show.stage("Search", of=2) as report:
            result = search_designs(problem, folder, workers=workers, scheduler=scheduler, progress=report)
        if not result.front:
            limits = "; ".join(map(str, problem.limits)) or "none"
            raise Refusal(
                f"has no design among {problem.trials} that keeps the limits ({limits})",
                kind=Kind.NO_RESULT,
                file=problem.study.name,
                remedy="widen the ranges of the parameters, or loosen the limits",
            )
        with show.stage("Parts", of=2) as report:
            failed = unprintable_designs(problem, result, report)
            seal(folder, failed)  # so that they stay out when the search is read later
            result = without(problem, result, failed)
        if not result.front:
            words = "has no design on its front whose drawn parts pass the print rules"
            raise Refusal(words, kind=Kind.NO_RESULT, file=problem.study.name)
        return Search(problem, result, tuple(save_search(problem, result, folder)))
