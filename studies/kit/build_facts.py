"""Facts that the manual states about one design: casts, and glues with their dangers."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass

from geometry.assembly.bill import Bill
from geometry.assembly.model import ArrayModel
from geometry.design.array_design import ArrayDesign
from geometry.molds import molds_of, plan_mold
from geometry.molds.ejector_pins import Ejector
from geometry.molds.mold_filling import closed_film, overflow
from geometry.molds.mold_forces import OpeningForces
from geometry.schema.print_processes import PrintProcess
from geometry.stock import Glue, Silicone, catalogue
from studies.kit.work_hours import count_casts

#: Dangers of a glue by a word of its chemistry: what it does, and what to wear.
_GLUE_DANGERS = {
    "cyanoacrylate": "Glues skin and eyelids within seconds, and its vapour irritates. Wear safety glasses but no "
    "cotton gloves, and open a window. Loosen glued skin with warm soapy water.",
    "epoxy": "Can cause an allergy for life once it touches skin. Wear nitrile gloves and change them when they are "
    "smeared.",
    "ultraviolet": "Irritates skin and eyes before it is cured. Wear nitrile gloves, and glasses that stop ultraviolet "
    "light while the lamp is on.",
    "acetoxy": "Gives off vinegar while it cures. Open a window and keep it away from eyes. The vapour corrodes bare "
    "copper, so let it cure before the microphones are mounted.",
}
_OTHER_GLUE = "Read the safety data sheet of the glue before you open it. Wear nitrile gloves and safety glasses."
#: Silicone mixed per silicone in the mold at least, a ratio, for what stays in the cup; assumed.
_CUP = 1.2
#: Smallest batch of two parts that a scale of 0.1 g divides well, g; assumed.
SMALLEST_BATCH = 5.0
#: Minutes until a joint may be tested, by a word of the glue's chemistry: assumed, and hours to its full strength.
_SETTING = {"cyanoacrylate": (5.0, 24.0), "epoxy": (30.0, 24.0), "ultraviolet": (2.0, 24.0), "acetoxy": (60.0, 24.0)}
_OTHER_SETTING = (60.0, 24.0)
#: Dangers of what else is used.
_RESIN = (
    "Liquid resin irritates skin and can cause an allergy for life. Wear nitrile gloves and safety glasses until the "
    "parts are cured. Isopropanol burns: no flame, no sparks, an open window. Cure rinsed resin in the sun before you "
    "throw it away, and pour none into the drain."
)
_POWDER = "Parts come from a service. Blow powder out of the bores outdoors and wear a dust mask."
_FILAMENT = "Let the nozzle cool before you reach into the printer."
_SILICONE = (
    "Platinum silicone is harmless to skin, but gloves of latex, sulphur and uncured resin keep it from curing. Wear "
    "nitrile gloves and cure the mold well."
)
_SLEEVE = (
    "The nozzle of a heat gun burns skin at once. Hold short pieces with tweezers and heat outdoors or at a window."
)
_SPRING = "Cut ends of spring wire fly and pierce. Wear safety glasses and cut inside a bag or under a cloth."


@dataclass(frozen=True)
class Cast:
    """Casting of the membranes of one kind."""

    membrane: str
    """Name of the membrane."""
    needed: int
    """Membranes that the array takes."""
    cavities: int
    """Cavities of the mold."""
    casts: int
    """Casts of one mold."""
    poured: float
    """Silicone in the cavities of one cast, ml."""
    mixed: float
    """Silicone that one cast takes at least, with what overflows and stays in the cup, ml."""
    grams: float
    """Mass of that, g."""
    batch_grams: float
    """Mass to mix for one cast, g: at least :data:`SMALLEST_BATCH`."""
    batch: float
    """Volume of that, ml."""
    shims: tuple[str, ...]
    """Names of the shims of the mold, and how much each raises the lid."""
    overflow: float
    """Silicone that flows over the rims into the grooves, ml."""
    wasted: float
    """Fraction of the batches that becomes no membrane of the array, in the mean over all casts."""
    film: float
    """Thickness of the silicone on the lands a minute after the weight is put on, mm."""
    opening: OpeningForces
    """Forces while a blade opens the mold, at most."""
    ejector: Ejector | None
    """Ejector holes of a cavity; None where it is blind."""
    closed: bool
    """True for a mold with a lid."""
    gap: float
    """Gap of base and lid beside the lands, mm."""

    @property
    def spare(self) -> int:
        """Membranes that the casts make in addition to those of the array."""
        return self.casts * self.cavities - self.needed


@dataclass(frozen=True)
class Danger:
    """Safety note on one material."""

    name: str
    """Name of the material."""
    words: str
    """Its dangers, and what to do."""


def casts_of(model: ArrayModel, bill: Bill) -> tuple[Cast, ...]:
    """Casting of each kind of membrane: cavities, casts, and silicone of one cast."""
    needed = Counter(part.part for part in model.placed if part.kind == "membrane")
    numbers = count_casts(model)
    return tuple(
        _cast(model, name, alike, needed[name], numbers[name], bill) for name, alike in molds_of(model.design).items()
    )


def _cast(model: ArrayModel, name: str, alike: ArrayDesign, needed: int, casts: int, bill: Bill) -> Cast:
    silicone = catalogue().silicone(alike).part
    density = silicone.density if isinstance(silicone, Silicone) else 1070.0
    plan, volume = plan_mold(alike), model.parts[name].val().Volume() / 1000
    poured = plan.cavity_volume * len(plan.centres) / 1000
    over = overflow(plan) / 1000
    mixed = max(poured * bill.waste.silicone_factor, (poured + over) * _CUP)
    grams = mixed * density / 1000
    batch_grams = max(grams, SMALLEST_BATCH)
    batch = 1000 * batch_grams / density
    of_kind = name.removeprefix("membrane")
    shims = [
        f"mold-shim-{step}{of_kind} raises the lid by {step * plan.mold.shim_step:g} mm"
        for step in range(1, alike.mold.shim_count + 1)
        if f"mold-shim-{step}{of_kind}" in model.parts
    ]
    return Cast(
        membrane=name,
        needed=needed,
        cavities=len(plan.centres),
        casts=casts,
        poured=poured,
        mixed=mixed,
        grams=grams,
        batch_grams=batch_grams,
        batch=batch,
        shims=tuple(shims),
        overflow=over,
        wasted=1 - needed * volume / (casts * batch),
        film=closed_film(plan),
        opening=plan.forces,
        ejector=plan.ejector,
        closed=plan.mold.kind == "two-part",
        gap=plan.mold.land_height,
    )


def glue_of(bill: Bill, joint: str) -> Glue | None:
    """Glue of a kind of joint: ``tube``, ``membrane`` or ``board``; None if the bill has no such joint."""
    part = next((item.part for item in bill.items if item.item == f"glue of {joint} joints"), None)
    return part if isinstance(part, Glue) else None


def minutes_to_set(glue: Glue | None) -> float:
    """Time after which a joint of a glue may be tested, min; assumed by its chemistry."""
    return _setting(glue)[0]


def setting_words(glue: Glue) -> str:
    """When a joint of a glue may be tested, and when it has its full strength."""
    minutes, hours = _setting(glue)
    return (
        f"Wait {minutes:g} min before you test or load a joint; it has its full strength after {hours:g} h. Both times "
        "are assumed, so read the data sheet of the glue"
    )


def _setting(glue: Glue | None) -> tuple[float, float]:
    chemistry = "" if glue is None else glue.chemistry
    return next((times for word, times in _SETTING.items() if word in chemistry), _OTHER_SETTING)


def dangers_of(model: ArrayModel, bill: Bill, process: PrintProcess) -> tuple[Danger, ...]:
    """Safety notes on every material of a build."""
    return tuple(_dangers(model, bill, process))


def _dangers(model: ArrayModel, bill: Bill, process: PrintProcess) -> Iterator[Danger]:
    resin = next((item.bought_as for item in bill.items if item.use == "printed"), "resin")
    of_process = {"mjf": _POWDER, "fdm": _FILAMENT}.get(process.name, _RESIN)
    yield Danger(resin, of_process)
    silicone = next((item.bought_as for item in bill.items if item.use == "cast"), "silicone")
    yield Danger(silicone, _SILICONE)
    tubes = [tube.tube for tube in model.layout.tubes]
    if any(tube.bore != "smooth" for tube in tubes):
        yield Danger("spring wire", _SPRING)
    if any(item.part is not None and item.part.kind == "sleeve" for item in bill.items):
        yield Danger("heat gun and sleeves", _SLEEVE)
    glues = dict.fromkeys(filter(None, (glue_of(bill, joint) for joint in ("tube", "membrane", "board"))))
    for glue in glues:
        words = next((text for word, text in _GLUE_DANGERS.items() if word in glue.chemistry), _OTHER_GLUE)
        yield Danger(f"{glue.name} ({glue.chemistry})", words)
