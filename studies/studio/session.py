"""One page and its design: its requests, and what it is sent."""

from __future__ import annotations

import asyncio
import secrets
from collections.abc import Awaitable, Callable, Mapping
from pathlib import Path
from time import monotonic
from typing import Any

from acoustic_fem.quantities.fidelity import ONE_DESIGN
from geometry.design.array_design import ArrayDesign, validated
from geometry.design.design_file import prototype, write_design
from geometry.design.field_values import field_values
from geometry.ground.argument_checks import check_choice
from geometry.ground.refusal import Kind, Refusal
from geometry.stock import catalogue
from studies.panels.curve_validity import Validity
from studies.panels.curves import CURVES
from studies.panels.designing import DesignState, design_key, refusal_of
from studies.panels.export_files import EXPORTS
from studies.panels.form import sizes_sold, stated_values
from studies.panels.form_hints import fields_without_effect, values_in_use
from studies.panels.pinned_panel import COMPARISON, field_rows, figure_rows
from studies.studio.drags import Drags
from studies.studio.exploration import Exploration, file_of
from studies.studio.exports import Exports
from studies.studio.fit_job import FitJob
from studies.studio.job_search import JobSearch
from studies.studio.messages import MessageError, packed, text_of, written
from studies.studio.page_words import SHARED, form_words
from studies.studio.stage import Job, Stage, notifier, outcome, progress
from studies.studio.touch_input import TouchInput
from studies.studio.workplace import Workplace

#: Sends a message to the page: text, or bytes.
Send = Callable[[str | bytes], Awaitable[None]]
#: Stages beside the curves, each shown by a panel, with the pause before they begin, s.
STAGES = {"points": 0.12, "surface": 0.0, "verdict": 0.3, "as_built": 0.5, "model": 0.1, "check": 1.0}


class Session:
    """Session of one page: its design, with undo and redo, and one job queue a stage.

    Args:
        design: to begin with.
        workplace: where jobs are done.
    """

    def __init__(self, design: ArrayDesign, workplace: Workplace) -> None:
        self.id = secrets.token_urlsafe(24)
        self.page: Any = None
        self.state = DesignState(design)
        self.pinned: ArrayDesign | None = None
        self._drags = Drags(self.state, self._post)
        self.exports = Exports(self.id, workplace, self._post, lambda: self.is_open)
        self.exploration = Exploration(workplace, self._post)
        self._search = JobSearch(workplace, self._post)
        self.fitting = FitJob(workplace, self._post, self._take_fitted)
        self._workplace = workplace
        self._quantity = "level"
        self._wanted: set[str] = set()
        self._send: Send | None = None
        #: When its page went, s; before one has come, when it was made.
        self.left = monotonic()
        #: Figures of the current design ("points") and of the pinned one ("pinned_points"), where they are known.
        self._compared: dict[str, dict[str, float | None]] = {}
        self._solving: asyncio.Task[None] | None = None
        self._solve_job: Job | None = None
        self.touches = TouchInput(workplace, self._post)
        self._last_values: tuple[dict[str, Any], frozenset[str]] = ({}, frozenset())
        self._last_hints: dict[str, Any] = {}
        self._last_validity: Validity | None = None
        self._stages = {"curves": Stage(self._curves), "pinned": Stage(self._curves)} | {
            name: Stage(self._figures, workplace.stop, pause)
            for name, pause in {**STAGES, "pinned_points": 0.0}.items()
        }

    # -- the page -----------------------------------------------------------------------------------
    @property
    def is_open(self) -> bool:
        """True if a page listens."""
        return self._send is not None

    async def join(self, send: Send) -> None:
        """A page listens from now on; it gets everything."""
        self._send, self._last_validity = send, None
        await self._post_design(whole=True)
        self._ask_all()
        await self._post_pinned()
        await self.exploration.post_again()
        await self.fitting.post_again()
        await self.exports.post_again()

    async def restore_quietly(self, values: dict[str, Any], saved: bool, send: Send) -> None:
        """Take up the design that a page kept while there was no studio, or say why not."""
        try:
            self.state.restore(values, "the design that the page kept")
        except Refusal as error:
            await send(written({"type": "refused-design", "message": str(error)}))
            return
        if saved:
            self.state.mark_saved()

    def leave(self, send: Send) -> None:
        """The page is gone; its design stays."""
        if self._send == send:
            self._send, self.left = None, monotonic()
            self.touches.stop()
            for stage in self._stages.values():
                stage.cancel()

    def end(self) -> None:
        """Nobody comes back: what is still done for the page is stopped, and its files are removed."""
        self.exploration.stop()
        self._search.stop()
        self.fitting.stop()
        self.exports.end()
        if self._solve_job is not None:
            self._workplace.stop_apart("solve", self._solve_job)
        self.touches.forget()

    async def take(self, message: Mapping[str, Any]) -> None:
        """Do what the page asks for.

        Raises:
            MessageError: it is not a message of a page of ours.
        """
        kind = message.get("do")
        action = _ACTIONS.get(kind) if isinstance(kind, str) else None
        if action is None:
            raise MessageError(kind=Kind.OUT_OF_RANGE, field="do", value=kind, allowed=_ACTIONS)
        await action(self, message)

    # -- the design ---------------------------------------------------------------------------------
    async def _set(self, message: Mapping[str, Any]) -> None:
        name, value = text_of(message, "name"), message.get("value")
        before = self.state.design
        try:
            values: Mapping[str, Any] = {name: value}
            if message.get("bought") is True and isinstance(value, (int, float)):
                values = catalogue().bought_values(name, float(value), before)
            self.state.set_values(values, message.get("gesture"))
        except Refusal as error:
            refused = refusal_of(before, name, value, error)
            await self._post({"type": "refused", **refused.__dict__})
            return
        await self._changed()

    async def _drag(self, message: Mapping[str, Any]) -> None:
        before = self.state.revision
        await self._drags.drag(message)
        await (self._post_design(whole=False) if self.state.revision == before else self._changed())

    async def _resize(self, message: Mapping[str, Any]) -> None:
        if await self._drags.resize(message):
            await self._changed()

    async def _remedy(self, message: Mapping[str, Any]) -> None:
        values = message.get("values")
        if not isinstance(values, dict):
            raise MessageError(kind=Kind.WRONG_TYPE, field="values", allowed="a table")
        try:
            self.state.set_values(values)
        except Refusal as error:
            await self._post({"type": "refused-design", "message": str(error)})
            return
        await self._changed(whole=True)

    async def _undo(self, message: Mapping[str, Any]) -> None:
        self.state.undo()
        await self._changed()

    async def _redo(self, message: Mapping[str, Any]) -> None:
        self.state.redo()
        await self._changed()

    async def _prototype(self, message: Mapping[str, Any]) -> None:
        try:
            self.state.open(prototype(text_of(message, "name")))
        except Refusal as error:
            await self._post({"type": "refused-design", "message": str(error)})
            return
        await self._changed(whole=True)

    async def _restore(self, message: Mapping[str, Any]) -> None:
        values = message.get("values")
        if not isinstance(values, dict):
            raise MessageError(kind=Kind.WRONG_TYPE, field="values", allowed="a table")
        try:
            self.state.restore(values, text_of(message, "source"))
        except Refusal as error:
            await self._post({"type": "refused-design", "message": str(error)})
            return
        if message.get("saved") is True:
            self.state.mark_saved()
        await self._changed(whole=True)

    async def _toml(self, message: Mapping[str, Any]) -> None:
        await self._post({"type": "toml", "text": write_design(self.state.design)})

    async def _changed(self, whole: bool = False) -> None:
        await self._post_design(whole)
        await self.touches.end("the design was changed: press Live to listen with it")
        self._ask_all()

    async def _post_design(self, whole: bool) -> None:
        design, state = self.state.design, self.state
        values = field_values(design)
        message: dict[str, Any] = {
            "type": "design",
            "session": self.id,
            "revision": state.revision,
            "undo": state.can_undo,
            "redo": state.can_redo,
            "unsaved": state.unsaved,
        }
        before, followers = self._last_values
        # Without the names of all fields a page does not know which tables follow others, nor which lines there are.
        if whole or values.keys() != before.keys() or design.followers != followers:
            message |= form_words(design)
        else:
            message["values"] = {name: value for name, value in values.items() if before[name] != value}
        self._last_values = values, design.followers
        hints = {"without_effect": fields_without_effect(design), "in_use": values_in_use(design)}
        if "form" in message or hints != self._last_hints:
            message["hints"] = self._last_hints = hints
        message["sizes"] = sizes_sold(design)
        await self._post(message)
        if self.pinned is not None:
            await self._post_comparison()

    # -- figures ------------------------------------------------------------------------------------
    async def _want(self, message: Mapping[str, Any]) -> None:
        wanted, quantity = message.get("stages"), text_of(message, "quantity")
        if quantity not in CURVES or not isinstance(wanted, list) or not all(each in [*STAGES] for each in wanted):
            raise MessageError(
                f"stages must be of {', '.join(STAGES)}, quantity one of {', '.join(CURVES)}", kind=Kind.OUT_OF_RANGE
            )
        fresh = {*wanted} - self._wanted
        for gone in self._wanted - {*wanted}:
            self._stages[gone].cancel()
        self._wanted = {*wanted}
        if quantity != self._quantity:
            self._quantity = quantity
            self._ask("curves")
            self._ask_pinned_curves()
        for name in fresh:
            self._ask(name)

    def _ask_all(self) -> None:
        self._ask("curves")
        for name in self._wanted:
            self._ask(name)

    def _ask(self, name: str) -> None:
        options = (self._quantity,) if name == "curves" else ()
        self._stages[name].ask(Job(name, self.state.revision, self.state.design, options))

    async def _post_pinned(self) -> None:
        """All of the pinned design: its page keeps it, as it does its own, for a studio that is started again."""
        stated = None if self.pinned is None else stated_values(self.pinned)
        await self._post({"type": "pinned", "stated": stated})
        self._ask_pinned_curves()
        if self.pinned is not None:
            self._stages["pinned_points"].ask(Job("pinned_points", self.state.revision, self.pinned))

    def _ask_pinned_curves(self) -> None:
        if self.pinned is not None:
            self._stages["pinned"].ask(Job("pinned", self.state.revision, self.pinned, (self._quantity,)))

    async def _curves(self, job: Job) -> None:
        found = await outcome(job, self._workplace.curves(job.design, job.options[0]), self._post)
        if found is None:
            return
        curves, known = found
        await self._post(packed(job, curves, known.words))
        if job.stage == "curves" and known != self._last_validity:
            self._last_validity = known
            await self._post({"type": "validity", "reason": known.reason, "solves": known.solves})

    async def _figures(self, job: Job) -> None:
        await progress(job, "", self._post)
        found = await outcome(job, self._workplace.result(job, notifier(job, self._post)), self._post)
        if found is None:
            return
        shown = {name: value for name, value in found.items() if name != "glb"}
        if job.stage == "model":
            shown["file"] = f"/models/{design_key(job.design)}.glb"
        await self._post({"type": "figures", "stage": job.stage, "revision": job.revision, "found": shown})
        if job.stage in ("points", "pinned_points"):
            self._compared[job.stage] = found["figures"]
            await self._post_compared()

    async def _stop(self, message: Mapping[str, Any]) -> None:
        name = text_of(message, "stage")
        if name == "export":
            await self.exports.stop()
        elif name == "solve" and self._solve_job is not None:
            self._workplace.stop_apart("solve", self._solve_job)
        elif name == "study":
            self.exploration.stop()
        elif name == "proposals":
            self._search.stop()
        elif name == "fit":
            self.fitting.stop()
        elif name == "live":
            await self.touches.end("stopped")
        elif name in STAGES:
            self._stages[name].cancel()

    async def _solve(self, message: Mapping[str, Any]) -> None:
        """Solve the design in 3-D; its curves follow."""
        if self._solving is not None and not self._solving.done():
            failure = {"stage": "solve", "revision": self.state.revision}
            await self._post({"type": "failed", **failure, "message": "one design is solved already: stop it first"})
            return
        self._solve_job = job = Job("solve", self.state.revision, self.state.design)
        self._solving = asyncio.create_task(self._solved(job))

    async def _solved(self, job: Job) -> None:
        await progress(job, "begins", self._post)
        if await outcome(job, self._workplace.solve(job.design, notifier(job, self._post), job), self._post, "stopped"):
            await self._post({"type": "solved"})
            if self.state.revision == job.revision:
                self._ask("curves")

    # -- two designs --------------------------------------------------------------------------------
    async def _pin(self, message: Mapping[str, Any]) -> None:
        values = message.get("values")  # of the design that a page had pinned when there was no studio
        if isinstance(values, dict):
            try:
                self.pinned = validated(values, "the pinned design that the page kept")
            except Refusal as error:
                await self._post({"type": "refused-design", "message": str(error)})
                return
        else:
            self.pinned = self.state.design if message.get("on") is True else None
        self._compared.pop("pinned_points", None)
        await self._post_comparison()
        await self._post_pinned()

    async def _post_comparison(self) -> None:
        if self.pinned is None:
            await self._post({"type": "comparison", "revision": self.state.revision, "pinned": None})
            return
        await self._post(
            {
                "type": "comparison",
                "revision": self.state.revision,
                "pinned": self.pinned.name,
                "differences": field_rows(self.state.design, self.pinned),
            }
        )

    async def _post_compared(self) -> None:
        """Figures of both designs side by side, once they are known of both."""
        if self.pinned is not None and len(self._compared) == 2:
            rows = figure_rows(self._compared["points"], self._compared["pinned_points"])
            await self._post({"type": "compared", "revision": self.state.revision, "rows": rows})

    # -- touches ------------------------------------------------------------------------------------
    async def _touch(self, message: Mapping[str, Any]) -> None:
        await self.touches.touch(self.state.design, self.state.revision, message)

    async def _listen(self, message: Mapping[str, Any]) -> None:
        await self.touches.listen(self.state.design, self.state.revision, message)

    async def _cards(self, message: Mapping[str, Any]) -> None:
        await self.touches.cards(self.state.design, self.state.revision)

    # -- new designs --------------------------------------------------------------------------------
    async def _job(self, message: Mapping[str, Any]) -> None:
        await self._search.words(self.state.design, self.state.revision)

    async def _propose(self, message: Mapping[str, Any]) -> None:
        await self._begin("proposals", self._search.search, message)

    async def _begin(
        self, stage: str, begin: Callable[[ArrayDesign, int, Mapping[str, Any]], None], message: Mapping[str, Any]
    ) -> None:
        """Begin work on the design as it is now; why it cannot begin is posted as the failure of its stage."""
        try:
            begin(self.state.design, self.state.revision, message)
        except MessageError:
            raise
        except Refusal as error:
            failure = {"stage": stage, "revision": self.state.revision, "message": str(error)}
            await self._post({"type": "failed", **failure})

    # -- arrays on bodies ---------------------------------------------------------------------------
    async def _body(self, message: Mapping[str, Any]) -> None:
        await self.fitting.show(self.state.design, self.state.revision, message)

    async def _fit(self, message: Mapping[str, Any]) -> None:
        await self._begin("fit", self.fitting.fit, message)

    async def _take_fitted(self, design: ArrayDesign, revision: int) -> bool:
        if self.state.revision != revision:
            return False
        self.state.open(design, saved=False)
        await self._changed(whole=True)
        return True

    async def _fitted_files(self, message: Mapping[str, Any]) -> None:
        job = Job("fit", self.state.revision, self.state.design)
        path = await outcome(job, self._workplace.fitted_files(job.design), self._post)
        if path is None:
            return
        if self.state.design is job.design:
            self.state.mark_saved()
            await self._post_design(whole=False)
        await self.exports.hand_out(path, f"{job.design.name}.zip")

    # -- studies ------------------------------------------------------------------------------------
    async def _study(self, message: Mapping[str, Any]) -> None:
        design = self.state.design
        job = Job("study", self.state.revision, design)
        if message.get("run") is True:
            await outcome(job, self.exploration.run(design, job.revision, message), self._post)
            return
        path = await outcome(job, self._study_file(design, message), self._post)
        if path is not None:
            await self.exports.hand_out(path, f"{design.name}-{path.name}")

    async def _study_file(self, design: ArrayDesign, message: Mapping[str, Any]) -> Path:
        return await self._workplace.study_file(design, file_of(design, message))

    async def _load(self, message: Mapping[str, Any]) -> None:
        try:
            self.state.open(self.exploration.design_of(message.get("number")), saved=False)
        except Refusal as error:
            await self._post({"type": "refused-design", "message": str(error)})
            return
        await self._changed(whole=True)

    # -- files --------------------------------------------------------------------------------------
    async def _export(self, message: Mapping[str, Any]) -> None:
        name, fidelity = text_of(message, "name"), message.get("fidelity", ONE_DESIGN)
        check_choice("export", name, (*EXPORTS, SHARED, COMPARISON), error=MessageError)
        if name == "design.toml":
            await self._save()
            return
        await self.exports.make(Job("export", self.state.revision, self.state.design, (name, fidelity)), self.pinned)

    async def _save(self) -> None:
        job = Job("save", self.state.revision, self.state.design)
        path = await outcome(job, self._workplace.save(job.design), self._post)
        if path is None:
            return
        if self.state.design is job.design:
            self.state.mark_saved()
            await self._post_design(whole=False)
        await self.exports.hand_out(path, f"{job.design.name}.toml")

    async def _post(self, message: dict[str, Any] | bytes) -> None:
        if self._send is not None:
            await self._send(message if isinstance(message, bytes) else written(message))


_ACTIONS: dict[str, Callable[[Session, Mapping[str, Any]], Awaitable[None]]] = {
    "set": Session._set,
    "remedy": Session._remedy,
    "drag": Session._drag,
    "resize": Session._resize,
    "undo": Session._undo,
    "redo": Session._redo,
    "prototype": Session._prototype,
    "restore": Session._restore,
    "toml": Session._toml,
    "want": Session._want,
    "stop": Session._stop,
    "solve": Session._solve,
    "pin": Session._pin,
    "export": Session._export,
    "touch": Session._touch,
    "listen": Session._listen,
    "cards": Session._cards,
    "job": Session._job,
    "propose": Session._propose,
    "body": Session._body,
    "fit": Session._fit,
    "fitted-files": Session._fitted_files,
    "study": Session._study,
    "load": Session._load,
}
