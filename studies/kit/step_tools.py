"""Things that each step of the manual needs: lines of the order list, or things that a workshop has."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from geometry.molds.mold_filling import CLOSING_FORCE
from studies.kit.ordering import OrderList

#: Things that the order list leaves out, because a workshop has them or lends them, with what they are for.
HAVE_READY: Mapping[str, str] = {
    "printer": "of the process that step 1 names",
    "computer": "with acoustic-fem, as READ-ME-FIRST.txt says",
    f"weight of {CLOSING_FORCE / 10:g} kg": "such as a bag of flour, on the lid of the mold",
    "printed template": "cutting-template-a4.pdf or -letter.pdf, printed at 100 %",
    "ruler": "to read the water gauge, and for long pieces",
    "soapy water": "a drop of dish soap in a glass of water",
    "flat plate": "glass or metal, larger than the array, to glue it on",
    "compressed air": "or a hand pump, to dry or clean parts",
    "talcum": "so that membranes do not stick together",
    "soft file": "for the corners of the boards",
    "calibration microphone": "with its amplifier, flat from 1 Hz; laboratories lend them",
    "small loudspeaker": "or a shaker, with the amplifier that drives it",
}


@dataclass(frozen=True)
class _Tools:
    """Things of one step of the manual, and those of only some designs."""

    always: tuple[str, ...]
    sometimes: tuple[str, ...] = ()


_STEPS: tuple[_Tools, ...] = (
    _Tools(("printer", "caliper")),
    _Tools(("printer",)),
    _Tools(
        ("clearing wire", "loupe", "nitrile gloves", "safety glasses", "compressed air"),
        ("wash pot", "isopropanol", "cure lamp"),
    ),
    _Tools(
        (
            *("scale", "mixing cups", "syringe", "release agent", "nitrile gloves", "paper wipes"),
            f"weight of {CLOSING_FORCE / 10:g} kg",
        )
    ),
    _Tools(("flat blade", "rod", "tweezers", "scalpel", "caliper", "talcum")),
    _Tools(("printed template", "side cutter", "scalpel", "loupe", "safety glasses")),
    _Tools(("tweezers", "scalpel", "printed template"), ("heat gun",)),
    _Tools(("syringe", "blunt needle", "tweezers", "glue of membrane joints")),
    _Tools(("syringe", "tee", "hose", "blunt needle", "modelling clay", "ruler", "soapy water", "loupe")),
    _Tools(
        ("glue of tube joints", "tweezers", "flat plate", "tape", "clearing wire", "modelling clay", "soapy water"),
        ("primer",),
    ),
    _Tools(("hot air", "solder paste", "soldering iron", "tweezers", "loupe", "multimeter", "soft file")),
    _Tools(("soldering iron", "tweezers"), ("glue of board joints", "gasket")),
    _Tools(("computer", "scale"), ("data logger", "controller")),
    _Tools(("computer", "calibration microphone", "small loudspeaker"), ("data logger", "controller")),
)
#: Number of the step in which an array is laid onto a body, if it has one, and its things.
_BODY_STEP, _ONTO_BODY = 13, _Tools(("tweezers", "glue of tube joints"))


def tools_of(order: OrderList, *, on_body: bool = False) -> dict[int, str]:
    """Things that each step needs, as the order list or :data:`HAVE_READY` call them, by the number of the step.

    Args:
        order: order list.
        on_body: the array is laid onto a body, which is a step of its own.
    """
    listed = {line.item for line in order.lines if line.ordered}
    steps = [*_STEPS]
    if on_body:
        steps.insert(_BODY_STEP - 1, _ONTO_BODY)
    return {
        step: ", ".join((*tools.always, *(each for each in tools.sometimes if each in listed)))
        for step, tools in enumerate(steps, start=1)
    }
