"""Responses of an array as bare arrays: its cells, solved or in closed form, joined by its network.

At the fidelities in closed form a design is a batch of one (:mod:`acoustic_fem.batch`) if a batch can hold it, so that
sweeps, which solve many, have the same values to the last bit. All other designs have the network of their cells.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

import acoustic_fem
from acoustic_fem.atlas.cell_in_atlas import atlas_admittance, least_angle
from acoustic_fem.atlas.cell_table import cell_atlas
from acoustic_fem.library.model_limits import check_model_limits
from acoustic_fem.quantities.fidelity import CLOSED_FORMS
from acoustic_fem.quantities.medium import Medium
from geometry.air.cells import Cell, cell_catalogue
from geometry.design.array_design import ArrayDesign
from geometry.ground.typed import Array, ComplexArray
from geometry.layout.arrangement import place_housings

if TYPE_CHECKING:
    from acoustic_fem.batch.network import BatchResponse
    from acoustic_fem.membrane.disc import KnownDiscs

#: Called with what is being done and the fraction done, 0 to 1.
Report = Callable[[str, float], None]


def array_responses(
    design: ArrayDesign,
    frequency: Array,
    fidelity: str,
    medium: Medium,
    report: Report = lambda message, fraction: None,
) -> tuple[dict[str, ComplexArray], list[dict[str, Any]]]:
    """Responses of an array, and how each distinct cell was computed.

    Args:
        design: the array.
        frequency: (n_freq,) float64, ascending, Hz.
        fidelity: one of :data:`acoustic_fem.FIDELITIES`.
        medium: the air.
        report: of the progress.

    Returns:
        Arrays by the names, shapes and units of :data:`acoustic_fem.library.transfer_functions.VARIABLES`, and a
        summary of each cell as JSON can hold it.

    Raises:
        Refusal: as of :func:`acoustic_fem.library.model_limits.check_model_limits`.
    """
    check_model_limits(design, frequency, medium)
    if fidelity in CLOSED_FORMS and acoustic_fem.batch.fits_batch(design):
        cells = cell_catalogue(design, place_housings(design)).distinct
        _warn_outside_errors(cells, frequency, fidelity)
        report("network", 0.95)
        batch = acoustic_fem.batch
        parameters, topology = batch.ArrayParameters.from_design(design, medium), batch.Topology.of(design)
        (response,) = batch.each_alone(parameters, topology, frequency, medium, fidelity)
        return named_responses(response), _summaries(cells, fidelity)
    solved: list[dict[str, Any]] = []

    def admittances(cells: tuple[Cell, ...]) -> dict[Cell, ComplexArray]:
        found, about = _cell_admittances(cells, frequency, fidelity, medium, report)
        solved.extend(about)
        report("network", 0.95)
        return found

    return joined_cells(design, frequency, medium, admittances), solved


def named_responses(one: BatchResponse) -> dict[str, ComplexArray]:
    """Responses of a batch of one design.

    Returns:
        Arrays by the names, shapes such as (n_point, n_microphone, n_freq), and units of
        :data:`acoustic_fem.library.transfer_functions.VARIABLES`.
    """
    transfer_function, impedance = one.transfer_function[0], one.point_impedance[0]
    return _named(transfer_function, impedance, one.microphone_impedance[0])


def _named(
    transfer_function: ComplexArray, impedance: ComplexArray, between_microphones: ComplexArray
) -> dict[str, ComplexArray]:
    return {
        "transfer_function": transfer_function,
        # the product, which may differ in the last bit: so that two of the three are all that a store needs
        "source_response": transfer_function * impedance[:, None, :],
        "point_impedance": impedance,
        "microphone_impedance": between_microphones,
    }


def joined_cells(
    design: ArrayDesign,
    frequency: Array,
    medium: Medium,
    admittances: Callable[[tuple[Cell, ...]], Mapping[Cell, ComplexArray]],
    discs: KnownDiscs | None = None,
) -> dict[str, ComplexArray]:
    """Responses of an array whose cells are solved by the caller.

    Args:
        design: the array.
        frequency: (n_freq,) float64, ascending, Hz.
        medium: the air.
        admittances: gives the admittances of its distinct cells, (n_freq, n_port, n_port) complex128, m^3/(Pa s).
        discs: membranes that need not be solved.

    Returns:
        Arrays by the names, shapes and units of :data:`acoustic_fem.library.transfer_functions.VARIABLES`.
    """
    layout = place_housings(design)
    catalogue = cell_catalogue(design, layout)
    response = acoustic_fem.network.solve_network(
        design, layout, catalogue, admittances(catalogue.distinct), frequency, medium, discs
    )
    transfer_function = response.source_response / response.point_impedance[:, None, :]
    return _named(transfer_function, response.point_impedance, response.microphone_impedance)


def closed_form(fidelity: str, cell: Cell, frequency: Array, medium: Medium) -> ComplexArray:
    """Admittance of a cell at a fidelity of :data:`acoustic_fem.quantities.fidelity.CLOSED_FORMS`.

    Args:
        fidelity: "lumped" or "atlas".
        cell: the cell.
        frequency: (n_freq,) float64, ascending, Hz.
        medium: the air.

    Returns:
        (n_freq, n_port, n_port) complex128, m^3/(Pa s).
    """
    if fidelity == "lumped":
        return acoustic_fem.cell.lumped_admittance(cell, frequency, medium)
    return atlas_admittance(cell, frequency, medium)


def _cell_admittances(
    cells: tuple[Cell, ...], frequency: Array, fidelity: str, medium: Medium, report: Report
) -> tuple[dict[Cell, ComplexArray], list[dict[str, Any]]]:
    """Nodal admittances of the cells, and how each was obtained."""
    if fidelity in CLOSED_FORMS:
        _warn_outside_errors(cells, frequency, fidelity)
        found = {cell: closed_form(fidelity, cell, frequency, medium) for cell in cells}
        return found, _summaries(cells, fidelity)
    solutions = acoustic_fem.cell.solve_cells(
        cells, frequency, medium, fidelity, progress=lambda label, fraction: report(label, 0.95 * fraction)
    )
    admittances = {cell: solution.admittance for cell, solution in solutions.items()}
    solved = [{"cell": cell.label, **solution.summary()} for cell, solution in solutions.items()]
    return admittances, solved


def _warn_outside_errors(cells: tuple[Cell, ...], frequency: Array, fidelity: str) -> None:
    """Warn where the errors of the atlas are not known."""
    if fidelity == "atlas":
        cell_atlas().warn_above(frequency)
        cell_atlas().warn_below(least_angle(cells))


def cell_summaries(design: ArrayDesign, fidelity: str) -> list[dict[str, Any]]:
    """How each distinct cell of a design is computed in closed form, as JSON can hold it.

    Args:
        design: the array.
        fidelity: "lumped" or "atlas".
    """
    return _summaries(cell_catalogue(design, place_housings(design)).distinct, fidelity)


def _summaries(cells: tuple[Cell, ...], fidelity: str) -> list[dict[str, Any]]:
    about: dict[str, Any] = {"method": "closed form"}
    if fidelity == "atlas":
        atlas = cell_atlas()
        about = {
            "method": f"atlas of cells, table {atlas.digest}",
            "errors": dict(atlas.errors),
            "errors_up_to_hz": atlas.known_up_to,
            "errors_from_degrees": atlas.known_from,
        }
    return [{"cell": cell.label, **about} for cell in cells]
