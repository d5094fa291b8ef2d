"""Files of a search: design files, a table of the front, and the report."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable
from pathlib import Path

from geometry import ArrayDesign, build_parts, load_design, print_report, save_design
from geometry.ground.refusal import Kind
from geometry.ground.text_files import read_text
from geometry.ground.whole_files import write_text
from geometry.printing.printability import PrintReport
from studies.findings.page import write_sweep_report
from studies.findings.result_table import table_of_search
from studies.optimization.journal import journal_exists
from studies.optimization.printable import worst_accepted
from studies.optimization.problem import Optimization, read_optimization
from studies.optimization.search import Candidate, OptimizationResult, found_so_far, without
from studies.study.parameter import StudyError

#: The study, its base and the best design, beside the journal of the trials.
_STUDY, _BASE, _BEST = "study.toml", "base.toml", "best.toml"
#: Designs of the front whose files are written and whose parts are drawn and measured.
LARGEST_FRONT = 10


def unprintable_designs(
    problem: Optimization, result: OptimizationResult, progress: Callable[[str, float], None] | None = None
) -> dict[int, str]:
    """Designs that would be among the best but whose drawn parts fail the print rules: reasons by number.

    With ``printable = "base"`` or "advised" only the fields are held to more than the rules' least: what is measured
    on the drawn parts must not fail, and with "advised" must not be at risk.
    """
    report = progress or (lambda message, fraction: None)
    verdicts: dict[int, str] = {}
    failed: dict[int, str] = {}
    front = result.front
    while unknown := [each for each in front[:LARGEST_FRONT] if each.number not in verdicts]:
        for each in unknown:
            report(f"design {each.number}", min(len(verdicts) / LARGEST_FRONT, 1.0))
            design = problem.study.base.with_values(each.values)
            printing = print_report(build_parts(design), design.printing.process)
            passes = printing.verdict in worst_accepted(problem.rules.demand)
            verdicts[each.number] = "" if passes else _failure(printing)
        failed = {number: why for number, why in verdicts.items() if why}
        front = without(problem, result, failed).front
    return failed


def _failure(printing: PrintReport) -> str:
    finding = printing.problems[0]
    return f"drawn and measured: {finding.rule} of the {finding.part.split('-')[0]} against the print rules"


def candidate_design(problem: Optimization, candidate: Candidate) -> ArrayDesign:
    """Design of a candidate, named after the study."""
    origin = f"Design {candidate.number} of the search {problem.study.name}; base {problem.study.base.name}"
    return problem.study.base.with_values(
        {**candidate.values, "name": problem.study.name, "description": origin}
    ).completed()


def save_search(problem: Optimization, result: OptimizationResult, out: Path) -> list[Path]:
    """Write best.toml, front/*.toml, front.csv and report.html. Their paths, most wanted first."""
    best, table, report, folder = (out / name for name in (_BEST, "front.csv", "report.html", "front"))
    write_text(out / _STUDY, problem.text)
    save_design(problem.study.base, out / _BASE)
    save_design(candidate_design(problem, result.front[0]), best)
    folder.mkdir(exist_ok=True)
    for old in folder.glob("*.toml"):
        old.unlink()
    for each in result.front[:LARGEST_FRONT]:
        save_design(candidate_design(problem, each), folder / f"{each.number}.toml")
    write_text(table, _csv(problem, result))
    write_sweep_report(
        table_of_search(problem, result), report, f"acoustic-fem best {out} {{number}} --out design-{{number}}.toml"
    )
    return [best, folder, table, report]


def read_search(out: Path) -> tuple[Optimization, OptimizationResult]:
    """Problem and result of a finished search, from its folder.

    Raises:
        StudyError: the folder is not that of a finished search.
    """
    if not journal_exists(out) or not all((out / name).is_file() for name in (_STUDY, _BASE, _BEST)):
        words = "is neither the results of a sweep (a folder with records) nor the folder of a finished search"
        raise StudyError(words, kind=Kind.UNSUITABLE, file=out)
    text = read_text(out / _STUDY, "the study of a search", StudyError)
    wanted = read_optimization(text, str(out / _STUDY), out, load_design(out / _BASE))
    return wanted, found_so_far(wanted, out)


def _csv(problem: Optimization, result: OptimizationResult) -> str:
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    parameters = [parameter.name for parameter in problem.study.parameters]
    names = [metric.name for metric in problem.metrics]
    writer.writerow(["design", *parameters, *names])
    for each in result.front:
        writer.writerow(
            [each.number, *(each.values[name] for name in parameters), *(f"{each.metrics[name]:.6g}" for name in names)]
        )
    return text.getvalue()
