"""The decoder of a library as C99 for a microcontroller, with what it costs."""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from dataclasses import dataclass

from acoustic_fem import Library
from geometry.ground.argument_checks import check_choice
from geometry.ground.refusal import Field, Kind, Refusal
from localize.embedded.boards import BOARDS, BoardName
from localize.embedded.budget import Budget, Cost, LargeDecoderWarning, cost_of, in_units
from localize.embedded.converter import AT_OVERLOAD, Converter, SampleScale, sample_scale, warn_of_coarse
from localize.embedded.decoder_tables import EmbeddedTables, Precision, embedded_tables
from localize.embedded.readme import readme
from localize.embedded.source import PREFIX, check_prefix, source_files, table_bytes, with_prefix
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.noise_model import NoiseChoice


@dataclass(frozen=True, eq=False)
class EmbeddedDecoder:
    """A decoder as C."""

    tables: EmbeddedTables
    """Tables of its array."""
    cost: Cost
    """Costs of the decoder."""
    files: Mapping[str, str]
    """Text of each file by name."""
    scale: SampleScale
    """Pressures of the samples of its firmware."""

    @property
    def table_bytes(self) -> int:
        """Bytes of the tables."""
        return table_bytes(self.tables)


def embed(
    library: Library | ArrayResponse,
    precision: Precision = "float32",
    microphone_noise: NoiseChoice = "design",
    budget: Budget | None = None,
    *,
    prefix: str = PREFIX,
    converter: Converter = AT_OVERLOAD,
    board: BoardName = "cortex-m",
) -> EmbeddedDecoder:
    """The decoder that needs no training as C99: no heap, constant tables, nothing but ``math.h``.

    It decides as :class:`localize.TouchStream` does with :class:`localize.BayesDecoder` on the library and, where the
    library has a design, :class:`localize.SoundTest`, behind the high-pass of 3 Hz and with no noise or hum followed.
    A converter whose steps are more than three times the microphone's noise gives a :class:`CoarseConverterWarning`, a
    decoder that is larger than the flash in the board's linker file a :class:`LargeDecoderWarning`.

    Args:
        library: transfer functions of at least two points and two microphones.
        precision: of the larger tables: ``float32``, or ``int16`` for little more than half the flash.
        microphone_noise: as of :class:`localize.BayesDecoder`.
        budget: what the microcontroller has for it; by default all it takes.
        prefix: first part of all global names and of the names of the files. Two arrays in one program need two.
        converter: that samples the microphones, for the pressures of the firmware's samples.
        board: whose sources are added: ``cortex-m``, ``zephyr`` or ``arduino``.

    Raises:
        Refusal: over the budget, with the numbers; an unknown precision or board; more microphones than it reads;
            volts or bits for a board of PDM microphones; a prefix that C does not allow; a converter in volts where
            the library has no design; or as :class:`localize.BayesDecoder`.
    """
    check_prefix(prefix)
    check_choice("board", board, tuple(BOARDS))
    chosen, microphones = BOARDS[board], len(response_of(library).microphones)
    if chosen.most_microphones is not None and microphones > chosen.most_microphones:
        problem = f"reads at most {chosen.most_microphones} microphones, and the array has {microphones}"
        raise Refusal(problem, kind=Kind.UNSUITABLE, field="board", value=board)
    if chosen.digital:
        _check_digital(board, converter)
    scale = sample_scale(response_of(library), converter, digital=chosen.digital)
    warn_of_coarse(scale, converter, digital=chosen.digital)
    tables = embedded_tables(library, precision, microphone_noise)
    cost = cost_of(tables)
    if budget is not None:
        budget.check(cost, f"{tables.name} in {precision}")
    if chosen.flash is not None and cost.flash > chosen.flash:
        warnings.warn(
            f"the decoder needs {in_units('flash', cost.flash)} of flash, and the linker file of the board "
            f"has {in_units('flash', chosen.flash)}; enter the memories of your chip there, or use raw mode, which "
            "needs no decoder",
            LargeDecoderWarning,
            stacklevel=2,
        )
    texts = {**source_files(tables, scale, chosen), "README.md": readme(tables, cost, scale, chosen)}
    return EmbeddedDecoder(tables, cost, with_prefix(texts, prefix), scale)


def _check_digital(board: BoardName, converter: Converter) -> None:
    """Refuse what PDM microphones do not have."""
    problem = f"is not allowed, because the source of the board {board} reads PDM microphones"
    if converter.volts is not None:
        scale = ("give ", Field("full_scale"), ", from their sensitivity in dBFS")
        raise Refusal(problem, kind=Kind.CONFLICT, field="volts", value=converter.volts, unit="V", remedy=scale)
    if converter.bits != AT_OVERLOAD.bits:
        remedy = f"leave it out: their samples have {AT_OVERLOAD.bits} bits"
        raise Refusal(problem, kind=Kind.CONFLICT, field="bits", value=converter.bits, remedy=remedy)
