"""Rows of the catalogue: one model for each kind of part, with its units and limits."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field, field_validator, model_validator

from geometry.ground.refusal import Kind, Refusal
from geometry.schema.field_errors import Hertz, Millimetre, Number, Section
from geometry.stock.land_patterns import find_land_pattern

#: Kinds of parts, which are also the keys of a file of parts.
PartKind = Literal["spring", "sleeve", "tubing", "sheet", "silicone", "resin", "glue", "sundry", "microphone", "logger"]
Unit = Literal["m", "ml", "dm^2", "piece"]
Price = Annotated[Number, Field(ge=0, le=1e5)]
Voltage = Annotated[Number, Field(gt=0, le=1000)]
#: Signals of a microphone by its output, in the order of the connector of its board.
SIGNALS: dict[str, tuple[str, ...]] = {
    "analog": ("VDD", "OUT", "GND"),
    "PDM": ("VDD", "CLOCK", "DATA", "SELECT", "GND"),
    "I2S": ("VDD", "SCK", "WS", "SD", "LR", "GND"),
}
#: Bandwidth of white noise with the power that the A-weighting of IEC 61672-1 leaves of it, 20 Hz to 20 kHz, Hz.
A_WEIGHTED_BANDWIDTH = 12467.0
#: Sound pressure of 0 dB SPL, Pa rms.
_REFERENCE = 20e-6
#: Sound pressure of 94 dB, at which the ratio of a microphone's signal to its noise is stated, Pa.
_STATED_AT = _REFERENCE * 10 ** (94 / 20)


class StockPart(Section):
    """A part, or a size class, that can be bought."""

    kind: ClassVar[PartKind]
    """Kind of part."""
    unit: ClassVar[Unit] = "piece"
    """Unit that the price is for."""

    maker: str = Field(default="", max_length=80, description="maker; empty for a size class that several shops sell")
    part_number: str = Field(default="", max_length=80, description="part number; empty where none is known")
    price: Price = Field(description="price per m, ml, dm^2 or piece, by kind, in USD")
    price_date: str = Field(
        pattern=r"^\d{4}(-\d{2}){0,2}$", description="date of the price: year, or year and month, or day"
    )
    price_source: str = Field(default="assumed", min_length=1, description="source of the price")
    source: str = Field(min_length=1, description='source of the sizes and figures; "assumed" where nobody read one')
    note: str = Field(default="", description="remark for people")

    @property
    def size(self) -> str:
        """Its size or figures, in words."""
        return ""

    @property
    def name(self) -> str:
        """Maker and part number, or the kind where there is none, and the size where neither says it."""
        if self.part_number:
            return f"{self.maker} {self.part_number}".strip()
        return " ".join(filter(None, (self.maker, self.material_words, self.kind, self.size)))

    @property
    def material_words(self) -> str:
        """Its material, for its name; empty where that says nothing."""
        return ""

    @property
    def assumed(self) -> bool:
        """True for a size class that no source names."""
        return self.source == "assumed"

    def to_dict(self) -> dict[str, Any]:
        """The part as JSON knows it."""
        plain = self.model_dump(mode="json", exclude_none=True)
        return {"kind": self.kind, "name": self.name, "size": self.size, "unit": self.unit, **plain}


class Spring(StockPart):
    """Close-wound coil spring, by the metre."""

    kind: ClassVar[PartKind] = "spring"
    unit: ClassVar[Unit] = "m"
    outer_diameter: Millimetre = Field(le=10, description="outside diameter")
    wire_diameter: Millimetre = Field(le=1, description="diameter of the wire")
    tolerance: Millimetre = Field(default=0.03, le=1, description="tolerance of the outside diameter, plus or minus")

    @model_validator(mode="after")
    def _has_a_bore(self) -> Spring:
        if self.outer_diameter <= 2 * self.wire_diameter:
            allowed = f"above 2 x wire_diameter ({2 * self.wire_diameter:g} mm)"
            raise Refusal(
                kind=Kind.CONFLICT, field="outer_diameter", value=self.outer_diameter, unit="mm", allowed=allowed
            )
        return self

    @property
    def bore(self) -> float:
        """Diameter of its bore, mm."""
        return round(self.outer_diameter - 2 * self.wire_diameter, 9)

    @property
    def size(self) -> str:
        """Outside diameter and wire."""
        return f"{self.outer_diameter:g} mm, wire {self.wire_diameter:g} mm"


class Sheath(StockPart):
    """Part that encloses a spring: a sleeve or a tubing."""

    unit: ClassVar[Unit] = "m"
    material: str = Field(default="", description="material, for people")
    tolerance: Millimetre = Field(default=0.05, le=1, description="tolerance of the wall, plus or minus")

    @property
    def material_words(self) -> str:
        """Its material."""
        return self.material

    def outside_over(self, spring: float) -> float | None:
        """Outside diameter over a spring of that outside diameter, both in mm; None where it does not go over it."""
        raise NotImplementedError


class Sleeve(Sheath):
    """Heat-shrink sleeve, by the metre."""

    kind: ClassVar[PartKind] = "sleeve"
    supplied_diameter: Millimetre = Field(le=50, description="bore as supplied")
    recovered_diameter: Millimetre = Field(le=50, description="bore after it shrank freely")
    recovered_wall: Millimetre = Field(le=5, description="wall after it shrank freely")

    @model_validator(mode="after")
    def _shrinks(self) -> Sleeve:
        if self.recovered_diameter >= self.supplied_diameter:
            allowed = f"below supplied_diameter ({self.supplied_diameter:g} mm)"
            value = self.recovered_diameter
            raise Refusal(kind=Kind.CONFLICT, field="recovered_diameter", value=value, unit="mm", allowed=allowed)
        return self

    def outside_over(self, spring: float) -> float | None:
        """Outside diameter after it shrank onto a spring, mm; None where it is too narrow or too wide.

        Its cross-section of plastic stays as it is: a wall is thicker the narrower it shrinks (Cobalt Polymers, "Heat
        shrink tubing behavior: how to predict recovered wall thickness", 2025).
        """
        if not self.recovered_diameter <= spring + 1e-9 <= self.supplied_diameter - _CLEARANCE + 2e-9:
            return None
        inner, outer = self.recovered_diameter, self.recovered_diameter + 2 * self.recovered_wall
        return round(math.sqrt(spring**2 + outer**2 - inner**2), 4)

    @property
    def size(self) -> str:
        """Bore before and after, and the wall."""
        return f"{self.supplied_diameter:g} to {self.recovered_diameter:g} mm, wall {self.recovered_wall:g} mm"


class Tubing(Sheath):
    """Micro-tubing, by the metre: over a spring, or alone as a smooth bore."""

    kind: ClassVar[PartKind] = "tubing"
    inner_diameter: Millimetre = Field(le=10, description="bore")
    outer_diameter: Millimetre = Field(le=15, description="outside diameter")

    @model_validator(mode="after")
    def _has_a_wall(self) -> Tubing:
        if self.inner_diameter >= self.outer_diameter:
            allowed = f"below outer_diameter ({self.outer_diameter:g} mm)"
            value = self.inner_diameter
            raise Refusal(kind=Kind.CONFLICT, field="inner_diameter", value=value, unit="mm", allowed=allowed)
        return self

    def outside_over(self, spring: float) -> float | None:
        """Its outside diameter if a spring slides into it with little gap, mm; None where it does not."""
        gap = self.inner_diameter - spring
        return self.outer_diameter if -1e-9 <= gap <= _WIDEST_GAP + 1e-9 else None

    @property
    def size(self) -> str:
        """Bore and outside."""
        return f"{self.inner_diameter:g} x {self.outer_diameter:g} mm"


class Sheet(StockPart):
    """Silicone sheet, by the square decimetre."""

    kind: ClassVar[PartKind] = "sheet"
    unit: ClassVar[Unit] = "dm^2"
    thickness: Millimetre = Field(le=20, description="thickness")
    shore_a: Number = Field(ge=0, le=90, description="hardness, Shore A")
    tolerance: Millimetre = Field(le=2, description="tolerance of the thickness, plus or minus")

    @property
    def size(self) -> str:
        """Thickness and hardness."""
        return f"{self.thickness:g} mm, Shore A {self.shore_a:g}"


class Silicone(StockPart):
    """Casting silicone of two parts, by the ml."""

    kind: ClassVar[PartKind] = "silicone"
    unit: ClassVar[Unit] = "ml"
    shore_a: Number | None = Field(default=None, ge=0, le=90, description="hardness, Shore A")
    shore_00: Number | None = Field(default=None, ge=0, le=100, description="hardness, Shore 00")
    modulus_100: Number | None = Field(
        default=None,
        gt=0,
        le=100,
        description="stress at a strain of 100 %, where published",
        json_schema_extra={"unit": "MPa"},
    )
    density: Number = Field(
        default=1070.0, ge=500, le=5000, description="density", json_schema_extra={"unit": "kg/m^3"}
    )
    pot_life: Number = Field(gt=0, le=1e4, description="pot life at 23 degC", json_schema_extra={"unit": "min"})
    cure_time: Number = Field(gt=0, le=1e4, description="cure at 23 degC", json_schema_extra={"unit": "h"})
    materials: tuple[str, ...] = Field(default=(), description="materials of a design that it makes")

    @property
    def size(self) -> str:
        """Hardness and modulus."""
        shore = "" if self.shore_a is None else f"Shore A {self.shore_a:g}"
        softer = "" if self.shore_00 is None else f"Shore 00-{self.shore_00:g}"
        modulus = "" if self.modulus_100 is None else f"{self.modulus_100:g} MPa at 100 %"
        return ", ".join(filter(None, (shore, softer, modulus)))


class Resin(StockPart):
    """Material of printed shells and molds, by the ml."""

    kind: ClassVar[PartKind] = "resin"
    unit: ClassVar[Unit] = "ml"
    processes: tuple[Literal["sla-resin", "dlp-fine", "fdm", "mjf"], ...] = Field(
        min_length=1, description="print processes that take it"
    )
    materials: tuple[str, ...] = Field(default=(), description="materials of a design that it is")
    modulus: Number | None = Field(
        default=None, gt=0, le=1e5, description="modulus, where published", json_schema_extra={"unit": "MPa"}
    )

    @property
    def size(self) -> str:
        """Print processes that take it."""
        return ", ".join(self.processes)


class Glue(StockPart):
    """Glue, by the ml."""

    kind: ClassVar[PartKind] = "glue"
    unit: ClassVar[Unit] = "ml"
    joins: tuple[Literal["tube", "membrane", "board"], ...] = Field(
        min_length=1, description="joints it is for: tube in its socket, membrane or board on the shell"
    )
    chemistry: str = Field(default="", description="what it is, for people")
    joint_volume: Number = Field(
        default=0.01, gt=0, le=10, description="volume for one joint", json_schema_extra={"unit": "ml"}
    )

    @property
    def size(self) -> str:
        """Chemistry and joints."""
        return f"{self.chemistry}; {', '.join(self.joins)}"


class Sundry(StockPart):
    """Small part of the bill that no field of a design describes, by the piece."""

    kind: ClassVar[PartKind] = "sundry"
    role: str = Field(min_length=1, description="name in the bill, such as gasket")

    @property
    def name(self) -> str:
        """Maker and part number, or its name in the bill."""
        return super().name if self.part_number else self.role


class StockMicrophone(StockPart):
    """MEMS microphone, by the piece."""

    kind: ClassVar[PartKind] = "microphone"
    part_number: str = Field(min_length=1, max_length=80, description="part number, the model of a design")
    output: Literal["analog", "PDM", "I2S"] = Field(description="output")
    sensitivity: Number = Field(
        ge=-80, le=0, description="output at 94 dB SPL, 1 kHz: dB re 1 V/Pa, or dB re full scale of a digital one"
    )
    signal_to_noise: Number = Field(
        ge=30, le=100, description="signal to noise at 94 dB SPL", json_schema_extra={"unit": "dB(A)"}
    )
    low_corner: Hertz | None = Field(
        default=None, gt=0, le=1000, description="frequency below which the response is 3 dB down"
    )
    overload: Number | None = Field(
        default=None, ge=90, le=180, description="overload at 10 % distortion", json_schema_extra={"unit": "dB SPL"}
    )
    port: Literal["bottom", "top"] = Field(description="side of the sound hole")
    length: Millimetre = Field(le=20, description="length of the package")
    width: Millimetre = Field(le=20, description="width of the package")
    height: Millimetre = Field(le=10, description="height of the package")
    land_pattern: str | None = Field(
        default=None, description="name of its land pattern; no board is drawn for a microphone without one"
    )
    pins: tuple[str, ...] = Field(default=(), description="signal of each pin, that of pin 1 first")
    pins_source: str = Field(default="", description="source of the land pattern and of the pins")

    @field_validator("land_pattern")
    @classmethod
    def _is_known(cls, name: str | None) -> str | None:
        if name is not None:
            find_land_pattern(name)
        return name

    @model_validator(mode="after")
    def _has_a_signal_for_each_pad(self) -> StockMicrophone:
        if self.land_pattern is None:
            return self
        pattern = find_land_pattern(self.land_pattern)
        given, count = ", ".join(self.pins), len(pattern.pads) + 1
        if len(self.pins) != count:
            allowed = f"a signal for each of the {count} pins of the land pattern"
            raise Refusal(kind=Kind.CONFLICT, field="pins", value=given, allowed=allowed)
        if {*self.pins} != {*SIGNALS[self.output]}:
            allowed = f"the signals of an output {self.output}: {', '.join(SIGNALS[self.output])}"
            raise Refusal(kind=Kind.CONFLICT, field="pins", value=given, allowed=allowed)
        return self

    @property
    def noise_density(self) -> float:
        """White equivalent input noise that its A-weighted ratio of signal to noise amounts to, Pa/sqrt(Hz)."""
        return _STATED_AT * 10 ** (-self.signal_to_noise / 20) / math.sqrt(A_WEIGHTED_BANDWIDTH)

    @property
    def values(self) -> Mapping[str, Any]:
        """Fields of a design that it determines, by dotted name; the noise corner is published for none."""
        known = {
            "microphone.model": self.part_number,
            "microphone.noise_density": float(f"{self.noise_density:.3g}"),
            "microphone.package_length": self.length,
            "microphone.package_width": self.width,
            "microphone.package_height": self.height,
            "microphone.source": f"stock: {self.source}",
        }
        if self.output == "analog":
            known["microphone.sensitivity"] = self.sensitivity
        if self.low_corner is not None:
            known["microphone.vent_corner"] = self.low_corner
        if self.overload is not None:
            known["microphone.overload"] = float(f"{math.sqrt(2) * _REFERENCE * 10 ** (self.overload / 20):.3g}")
        return known

    @property
    def size(self) -> str:
        """Output, noise, low corner, overload and package."""
        corner = "low corner not published" if self.low_corner is None else f"from {self.low_corner:g} Hz"
        loudest = "" if self.overload is None else f"{self.overload:g} dB SPL"
        package = f"{self.length:g} x {self.width:g} x {self.height:g} mm, port {self.port}"
        noise = f"{self.signal_to_noise:g} dB(A)"
        return ", ".join(filter(None, (self.output, f"{self.sensitivity:g} dB", noise, corner, loudest, package)))


class Logger(StockPart):
    """Data logger or audio interface that records analog microphones, by the piece."""

    kind: ClassVar[PartKind] = "logger"
    part_number: str = Field(min_length=1, max_length=80, description="model")
    channels: int = Field(ge=1, le=1024, description="analog inputs")
    bits: int = Field(ge=8, le=32, description="bits of a sample")
    full_scales: tuple[Voltage, ...] = Field(
        min_length=1,
        description="peak voltages of the largest sample, one per range, or the largest and the smallest of a knob",
        json_schema_extra={"unit": "V"},
    )
    gain: Literal["ranges", "knob"] = Field(description="ranges that are chosen, or a knob between two ends")
    dynamic_range: Number = Field(ge=20, le=160, description="full scale over noise", json_schema_extra={"unit": "dB"})
    input_resistance: Number = Field(
        gt=0,
        le=1e12,
        description="resistance of an input, or of the resistor to ground that it needs",
        json_schema_extra={"unit": "ohm"},
    )
    coupling: Literal["AC", "DC"] = Field(description="AC if the input has a capacitor of its own")
    low_corner: Hertz | None = Field(
        default=None, gt=0, le=1000, description="frequency below which the inputs are not specified"
    )
    terminals: tuple[str, str] = Field(
        description="names of the terminals of channel N, signal and ground, with {n} for its number"
    )
    first_terminal: int = Field(default=1, ge=0, le=1, description="number that the maker gives to the first channel")
    sound_card: bool = Field(default=False, description="true if computers see it as a sound card, which live reads")

    @property
    def size(self) -> str:
        """Channels, bits, full scales and coupling."""
        span = " to " if self.gain == "knob" else ", "
        scales = span.join(f"{value:g}" for value in self.full_scales)
        return f"{self.channels} inputs, {self.bits} bit, full scale {scales} V peak, {self.coupling} coupled"


#: Least difference of a sleeve's bore as supplied from a spring that goes into it, and widest gap of a tubing, mm.
_CLEARANCE, _WIDEST_GAP = 0.05, 0.12


class StockFile(Section):
    """File of parts: a list for each kind, all optional."""

    replace: tuple[PartKind, ...] = Field(
        default=(), description="kinds of which only the parts of this file count, not those that come with the package"
    )
    spring: tuple[Spring, ...] = Field(default=(), description="springs")
    sleeve: tuple[Sleeve, ...] = Field(default=(), description="heat-shrink sleeves")
    tubing: tuple[Tubing, ...] = Field(default=(), description="micro-tubing")
    sheet: tuple[Sheet, ...] = Field(default=(), description="silicone sheet")
    silicone: tuple[Silicone, ...] = Field(default=(), description="casting silicones")
    resin: tuple[Resin, ...] = Field(default=(), description="materials for printing")
    glue: tuple[Glue, ...] = Field(default=(), description="glues")
    sundry: tuple[Sundry, ...] = Field(default=(), description="small parts")
    microphone: tuple[StockMicrophone, ...] = Field(default=(), description="microphones")
    logger: tuple[Logger, ...] = Field(default=(), description="data loggers")

    def parts(self) -> Iterator[StockPart]:
        """Every part of the file, by kind."""
        for kind in KINDS:
            yield from getattr(self, kind)


#: All kinds, in the order of the catalogue.
KINDS: tuple[PartKind, ...] = PartKind.__args__  # type: ignore[attr-defined]
