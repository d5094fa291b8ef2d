"""The design of an array: its parts, how they are joined, laid out and made.

Lengths are millimetres, moduli megapascals, frequencies hertz. A design is immutable; changed copies
come from :meth:`ArrayDesign.with_values`. Every section refuses unknown keys and non-finite numbers
with a :class:`geometry.DesignError` of one line. The fields of the parts live in
:mod:`geometry.schema.part_fields`, reading and writing in :mod:`geometry.design.design_file`, the rules between
fields in :mod:`geometry.design.design_rules`.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Self

from pydantic import ValidationError, model_validator

from geometry.design.changes import changed
from geometry.design.design_rules import check_consistency
from geometry.ground.late import function_above
from geometry.ground.shown import Shown
from geometry.plan.wiring_graph import check_topology
from geometry.schema.array_fields import StatedArray
from geometry.schema.field_errors import error_from_validation

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class ArrayDesign(Shown, StatedArray):
    """Design of one array: the values of a :class:`StatedArray`, checked as a whole."""

    def shown(self) -> tuple[str, Mapping[str, object]]:
        """Title and facts that a session and a notebook show."""
        tube, resonator, membrane = self.tube, self.resonator, self.membrane
        return f"Design {self.name}", {
            "description": self.description,
            "points": f"{self.point_count} in {len(self.lines)} line(s), layout {self.layout.kind}",
            "microphones": f"{', '.join(self.microphones)} ({self.microphone.model})",
            "cavity": f"{resonator.cavity_diameter:g} x {resonator.cavity_height:g} mm, {resonator.shape}",
            "membrane": f"{membrane.thickness:g} mm, {membrane.material}",
            "tube": f"length {tube.length:g} mm, inner diameter {tube.inner_diameter:g} mm, bore {tube.bore}",
            "air": f"{self.air.temperature:g} degC, humidity {self.air.humidity:g}, {self.air.pressure:g} Pa"
            + (f", enclosed at {self.air.overpressure:+g} Pa" if self.air.overpressure else ""),
            "printing": f"{self.printing.process}, {self.printing.material}",
            "changed copies": 'design.with_values({"tube.length": 14.0})',
        }

    def draw(self) -> Figure:
        """Figure of the array in plan, mm: numbered points, tubes and microphones.

        Raises:
            MissingExtra: matplotlib is not installed.
        """
        figure: Figure = function_above("geometry.layout.plan_drawing", "draw_plan")(self)
        return figure

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        check_topology(self.microphones, [(line.between, line.points) for line in self.lines])
        check_consistency(self)
        return self

    # -- changed copies -----------------------------------------------------------------------------
    def with_values(self, values: Mapping[str, Any]) -> ArrayDesign:
        """A copy with fields changed by dotted name, checked again as a whole.

        If the design does not state a microphone tube, it stays equal to the tube, unless one of its own fields is
        changed.

        Args:
            values: for example ``{"tube.inner_diameter": 0.5, "lines.0.points": 6}``.

        Raises:
            DesignError: no such field, or the changed design is not valid.
        """
        still = self.followers - {name.split(".")[0] for name in values}
        data = changed(self.model_dump(), values, self.name)
        return validated({name: value for name, value in data.items() if name not in still}, self.name)

    def completed(self) -> ArrayDesign:
        """The same design with the built-in materials it uses written out, so that it stands alone."""
        used = {name for _, name in self.materials_in_use()}
        return self.model_copy(
            update={"materials": {**{name: self.material(name) for name in sorted(used)}, **self.materials}}
        )


def validated(data: Mapping[str, Any], source: str) -> ArrayDesign:
    """A design from plain values.

    Args:
        data: tables as dictionaries, as TOML gives them.
        source: name of the file or design, for messages.

    Raises:
        DesignError: not a valid design.
    """
    try:
        return ArrayDesign.model_validate(data)
    except ValidationError as error:
        raise error_from_validation(error, ArrayDesign, data, source) from None
