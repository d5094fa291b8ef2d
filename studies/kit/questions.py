"""Answers to the questions of ``questions.toml``, computed from the design, with the part of the manual for each."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from importlib import resources

import studies
from geometry.assembly.model import ArrayModel
from geometry.ground.refusal import Refusal, counted
from geometry.ground.text_files import parse_toml
from geometry.printing.plates import Plates
from geometry.schema.print_processes import PrintProcess
from geometry.stock import Silicone, catalogue
from studies.kit.body_files import BodyFiles
from studies.kit.build_facts import Cast, glue_of
from studies.kit.cutting_template import Strip
from studies.kit.electronics_files import Electronics
from studies.kit.expected_signals import FREQUENCY, ExpectedSignal
from studies.kit.jobs import BUILD, BUY, CUT, PRINT
from studies.kit.leak_testing import WATCHED, LeakTest
from studies.kit.logger_levels import two_digits
from studies.kit.ordering import OrderList
from studies.kit.step_drawings import glued_face_words
from studies.kit.touch_leak_test import LeakSign
from studies.kit.tube_order import sheath_orders, spring_orders

#: Number of the step of the first recording in the manual of an array that lies on no body.
_RECORDING = 13


@dataclass(frozen=True)
class Answer:
    """Answer to one question."""

    question: str
    """The question."""
    words: str
    """The answer."""
    anchor: str
    """Part of the manual that says more."""


@dataclass(frozen=True)
class Facts:
    """Facts that the answers are made of."""

    model: ArrayModel
    """The array."""
    plates: Plates
    """Plates to print."""
    process: PrintProcess
    """Printing process."""
    verdict: str
    """Verdict of the print report."""
    order: OrderList
    """Order list."""
    casts: tuple[Cast, ...]
    """Casting."""
    strips: tuple[Strip, ...]
    """Pieces to cut."""
    leaks: tuple[LeakTest, ...]
    """Leak tests."""
    signals: tuple[ExpectedSignal, ...]
    """Expected signals."""
    leak_signs: tuple[LeakSign, ...]
    """Changes by which touches show leaks."""
    electronics: Electronics
    """Wiring, board and levels of the microphones."""
    supported: tuple[str, ...]
    """Names of the parts that need supports while they are printed."""
    body: BodyFiles | None
    """Solids for the body that the array lies on; None for other arrays, and where its file is not at hand."""

    @property
    def recording_step(self) -> int:
        """Number of the step of the first recording: an array on a body has one step more before it."""
        return _RECORDING + (self.model.design.layout.frozen is not None)


def answers_of(facts: Facts) -> tuple[Answer, ...]:
    """Questions of a maker, in the order of work, with their answers."""
    text = (resources.files(studies) / "kit" / "questions.toml").read_text(encoding="utf-8")
    questions: dict[str, str] = parse_toml(text, "questions.toml", Refusal)
    answers = (*_buying(facts), *_printing(facts), *_casting(facts), *_building(facts))
    return tuple(Answer(questions[name], words, anchor) for name, words, anchor in answers)


def _buying(facts: Facts) -> Sequence[tuple[str, str, str]]:
    order, money = facts.order, facts.order.bill.currency
    model = facts.electronics.wiring.model
    line = next(line for line in order.lines if line.item == facts.model.design.microphone.model)
    return (
        (
            "cost",
            f"Materials with spares {order.cost('array'):.2f} {money}, molds {order.cost('molds'):.2f} {money}, "
            f"consumables {order.cost('consumable'):.2f} {money}, tools {order.cost('tool'):.2f} {money}. If "
            f"you buy every bottle and metre whole, these cost {order.cost_of_packs:.2f} {money}. Electronics with one "
            f"data logger cost {order.cost('electronics'):.2f} {money}, so everything costs "
            f"{order.cost_of_everything:.2f} {money}. {BUY}/costs.csv has the sum.",
            "buy",
        ),
        (
            "hours",
            f"{order.hours:.1f} h of work and {order.waiting:.0f} h of waiting for prints, silicone and glue.",
            "hours",
        ),
        ("order_first", "Microphones and springs, because their delivery takes longest.", "buy"),
        (
            "microphone",
            f"{line.amount} of {model}, spares included"
            + (
                "."
                if line.part is None
                else f": {line.bought_as}, {line.part.price:g} {money} each ({line.part.price_source})."
            ),
            "buy",
        ),
        (
            "tools",
            ", ".join(line.item for line in order.lines if line.purpose == "tool") + ".",
            "buy",
        ),
    )


def _printing(facts: Facts) -> Sequence[tuple[str, str, str]]:
    plates, parts = facts.plates.plates, facts.model.parts
    first = [plate for plate in plates if plate.holds_molds] or plates[:1]
    shells = ", ".join(f"{parts.counts[n]} x {n}" for n in parts if parts.kinds[n] == "shell" and parts.counts[n])
    carrier = "carrier" in parts
    return (
        (
            "print_first",
            f"The molds, because membranes cure while you print the array: {', '.join(p.path.name for p in first)} in "
            f"{PRINT}, with {', '.join(f'{n} x {name}' for plate in first for name, n in plate.copies.items())}.",
            "step-1",
        ),
        (
            "printer",
            f"Any printer of this kind: {facts.process.title}. The plates are arranged for a build volume of "
            f"{' x '.join(f'{size:g}' for size in facts.process.build_volume)} mm.",
            "step-1",
        ),
        (
            "plates",
            f"{counted(len(plates), 'plate')}: {', '.join(p.path.name for p in plates)}.",
            "step-1",
        ),
        (
            "pose",
            "As the plates hold them. The table of printed parts says which side of each part looks up. A part that "
            "you print alone lies the same way.",
            "step-2",
        ),
        (
            "printable",
            f"The print report says {facts.verdict}. Read {PRINT}/print-report.html.",
            "step-1",
        ),
        (
            "shells",
            "all shells in one carrier." if carrier else f"{shells}.",
            "step-3",
        ),
        (
            "port",
            "A wire of the diameter of the bore goes through, or you see light.",
            "step-3",
        ),
    )


def _casting(facts: Facts) -> Sequence[tuple[str, str, str]]:
    casts, design = facts.casts, facts.model.design
    silicone = catalogue().silicone(design).part
    pot, cure = (silicone.pot_life, silicone.cure_time) if isinstance(silicone, Silicone) else (0.0, 0.0)
    name = "a silicone of the design's hardness" if silicone is None else silicone.name
    each = casts[0]
    strips = "; ".join(f"{s.name}: {s.count} x {s.what} of {s.length:g} mm" for s in facts.strips)
    springs = [
        f"{each.size}; {each.length_words}; {each.source}"
        for each in spring_orders(design, facts.model.layout, facts.order)
    ]
    return (
        ("silicone", f"{name}, for {design.membrane.material}.", "step-4"),
        (
            "mixed",
            "; ".join(f"{c.batch_grams:.3g} g ({c.batch:.3g} ml) a cast of {c.membrane}" for c in casts) + ".",
            "step-4",
        ),
        (
            "casts",
            "; ".join(
                f"{c.casts} of {c.membrane} with {counted(c.cavities, 'cavity')}, which take {c.poured:.2g} ml"
                for c in casts
            )
            + ".",
            "step-4",
        ),
        ("pot_life", f"{pot:g} min, then {cure:g} h at 23 degC.", "step-4"),
        (
            "mold",
            f"The face that will be glued points up, towards the lid. To recognize it: {glued_face_words(design)}.",
            "step-5",
        ),
        (
            "thickness",
            f"{', '.join(sorted({f'{design.of_kind(kind).membrane.thickness:g} mm' for kind in design.kinds}))}. "
            "The depth of the cavities and the shims under the lid set it. "
            f"Write down what you measure: {BUILD}/record.toml.",
            "step-5",
        ),
        (
            "too_thin",
            (f"Raise the lid: {'; '.join(each.shims)}. " if each.shims else "")
            + "If it is too thick, or if shims do not match, print the base again: write the stated minus the measured "
            "thickness as [mold] trim into design.toml and run acoustic-fem parts.",
            "step-5",
        ),
        ("lengths", f"{strips}.", "step-6"),
        (
            "spring",
            f"{'. '.join(springs) or 'none, the tubing is smooth'}.",
            "step-6",
        ),
        (
            "sheath",
            f"{'. '.join(each.words for each in sheath_orders(design, facts.model.layout, facts.order))}.",
            "step-7",
        ),
        ("template", f"{CUT}/cutting-template-a4.pdf or -letter.pdf, printed at 100 %.", "step-6"),
    )


def _building(facts: Facts) -> Sequence[tuple[str, str, str]]:
    bill, test, electronics = facts.order.bill, facts.leaks[0], facts.electronics
    glues = {joint: glue_of(bill, joint) for joint in ("tube", "membrane", "board")}
    names = {joint: "a glue that the catalogue lacks" if glue is None else glue.name for joint, glue in glues.items()}
    first, design = facts.signals[0], facts.model.design
    touch, lines = electronics.first_touch, [f"from {' to '.join(line.between)}" for line in design.lines]
    board = names["board"] if design.microphone.gasket_width is None else "none: the board lies on its gasket"
    return (
        ("glue_membrane", names["membrane"] + ".", "step-8"),
        ("glue_tube", names["tube"] + ".", "step-10"),
        ("glue_board", board + ".", "step-12"),
        (
            "order",
            f"Membranes first, then line by line, {', '.join(lines)}, housings without their boards included, as "
            f"{BUILD}/assembly.txt lists. The boards come last.",
            "step-10",
        ),
        (
            "leak",
            f"Raise the gauge to {test.water:.0f} mm of water ({test.pressure:.0f} Pa). In {WATCHED:g} s this "
            f"height may fall by {test.fall} mm at most.",
            "step-9",
        ),
        ("bulge", f"{test.bulge:.2g} mm in the middle.", "step-9"),
        (
            "pin",
            _pin_words(electronics),
            "step-12",
        ),
        ("logger", _logger_words(electronics), f"step-{facts.recording_step}"),
        (
            "overload",
            " ".join(electronics.levels.verdict) + f" The first recording needs touches of {touch.seconds:g} s with "
            f"{touch.force:.2g} N ({two_digits(touch.grams)} g) at most.",
            f"step-{facts.recording_step}",
        ),
        (
            "recording",
            f"For point 1, microphone {first.louder} is {first.difference:.1f} dB louder than "
            f"{first.softer or 'no other'} at {FREQUENCY:g} Hz; the table has every point.",
            f"step-{facts.recording_step}",
        ),
    )


def _pin_words(electronics: Electronics) -> str:
    """Way of pin 2 of the microphone, and of pin 2 of its board."""
    wiring = electronics.wiring
    pin = wiring.pins[1] if wiring.pins else None
    words = (
        f"The program has no source for the pin numbers of {wiring.model}, so no file states them. "
        "Look up the name of pin 2 in its data sheet, then wire that name as the table of wires says."
        if pin is None
        else f"Pin 2 of {wiring.model} is {pin} ({wiring.source})."
    )
    wire = next((each for each in electronics.wires if each.pin == 2), None)
    if wiring.board is None or wire is None:
        return words
    return f"{words} Pin 2 of the connector of its board is {wire.signal}, {wire.colour}: {wire.goes_to}."


def _logger_words(electronics: Electronics) -> str:
    """Most suitable logger, with its range."""
    if not electronics.levels.loggers:
        return (
            "No logger in the catalogue has an input for each microphone. Use one with enough inputs that reaches 3 Hz."
        )
    first = electronics.levels.loggers[0]
    if first.volts is None:
        return f"None: {first.name}. A controller reads it; embed writes the firmware."
    others = ", ".join(each.name for each in electronics.levels.loggers[1:])
    other = f" Also possible: {others}." if others else ""
    return f"{first.name} with a largest sample of {first.volts:.3g} V.{other} {electronics.logger_needs}"
