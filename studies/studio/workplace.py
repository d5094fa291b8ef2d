"""Resources that all sessions share: threads, the process for CAD, and what was computed already."""

from __future__ import annotations

import asyncio
import gc
import hashlib
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from shutil import rmtree
from tempfile import TemporaryDirectory, mkdtemp
from typing import Any

from acoustic_fem import Library
from acoustic_fem.atlas import QuickFidelity
from acoustic_fem.quantities.fidelity import Fidelity
from geometry.design.array_design import ArrayDesign
from geometry.ground.process_messages import Stopped
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.whole_files import write_text
from studies.panels.body_panel import body_shape, fit_to_body, write_fitted
from studies.panels.cad_panel import check_figures, model_of_array, read_upload
from studies.panels.curve_validity import Validity, validity
from studies.panels.curves import Curves, curves_of, quick_library
from studies.panels.designing import design_key
from studies.panels.exploring import FoundDesigns, run_study, study_so_far, write_study
from studies.panels.export_files import make_export
from studies.panels.job_panel import job_words, proposals_for
from studies.panels.live_panel import listen_live, sound_cards
from studies.panels.pinned_panel import make_comparison
from studies.panels.points import as_built_figures, point_figures
from studies.panels.recognizing import store_recognizer, with_kinds, write_letter
from studies.panels.solved_curves import SolvedCurves, solve_curves
from studies.panels.touching import manifest_scale, membranes, replay_recording, simulate_slide, simulate_touch
from studies.panels.verdict_panel import verdict_figures
from studies.studio.body_store import BodyStore
from studies.studio.result_cache import ResultCache
from studies.studio.stage import Job
from studies.studio.task_process import TaskProcess

#: Message to a page whose file or study waits for that of another page.
WAITING = "waiting for that of another page"
#: Libraries and results of each stage that are kept, and models in three dimensions, which are larger.
MOST_RESULTS, MOST_MODELS = 64, 12
#: Shapes of bodies that are kept.
MOST_SHAPES = 4


class Workplace:
    """Threads, processes and results of a studio.

    Closed with :meth:`close`; what it writes for export goes into a temporary folder that goes with it.

    Args:
        folder: of the design file, which has the body of an array that was fitted to one; None if there is no file.
        design: that the studio is started with.
    """

    def __init__(self, folder: Path | None = None, design: ArrayDesign | None = None) -> None:
        # One thread a stage: a slow one delays no other, and none works on two designs at once.
        self._threads = {
            name: ThreadPoolExecutor(1, f"studio-{name}")
            for name in (
                "curves",
                "points",
                "as_built",
                "cad",
                "save",
                "export",
                "live",
                "study",
                "touch",
                "proposals",
                *("solve", "found", "fit"),
            )
        }
        self.cad = TaskProcess(_warm_up)
        self._decoder = TaskProcess(_import_decoder, "the decoder", in_background=False)
        # Seconds of Python: in a thread they would stand in the way of every curve.
        self._predictor = TaskProcess(_import_decoder, "the process of as-built sensors")
        self._fitter = TaskProcess(_warm_up, "the process that fits arrays", in_background=False)
        self._fits = 0
        self._libraries: ResultCache[tuple[Library, QuickFidelity]] = ResultCache(MOST_RESULTS)
        self._results: ResultCache[dict[str, Any]] = ResultCache(MOST_RESULTS)
        self._solved: ResultCache[SolvedCurves] = ResultCache(MOST_RESULTS)
        self._models: ResultCache[dict[str, Any]] = ResultCache(MOST_MODELS)
        self._shapes: ResultCache[dict[str, Any]] = ResultCache(MOST_SHAPES)
        self._folder = TemporaryDirectory(prefix="acoustic-fem-studio-")
        self.bodies = BodyStore(Path(self._folder.name) / "bodies", folder, design)
        self._processes: dict[str, TaskProcess] = {}
        self._queued: dict[object, Future[Any]] = {}

    def warm_up(self, design: ArrayDesign) -> None:
        """Import and solve once what the first change would otherwise wait for; returns at once."""
        self._threads["curves"].submit(self._warm_up_threads, design)
        self._threads["cad"].submit(self.cad.start)

    def _warm_up_threads(self, design: ArrayDesign) -> None:
        self.library(design)
        # The decoder's imports take seconds: after the first curves, not in their way.
        self._threads["points"].submit(_settle)

    def library(self, design: ArrayDesign) -> tuple[Library, QuickFidelity]:
        """The quick library of a design at the frequencies of the curves, and its fidelity."""
        key = design_key(design)
        found = self._libraries.get(key)
        if found is None:
            found = quick_library(design)
            self._libraries.put(key, found)
        return found

    async def curves(self, design: ArrayDesign, quantity: str) -> tuple[Curves, Validity]:
        """Curves of one quantity of a design, and how far they are from 3-D."""

        def work() -> tuple[Curves, Validity]:
            solved = self._solved.get(design_key(design))
            if solved is not None:
                return curves_of(solved.transfer_function, quantity), solved.validity
            library, fidelity = self.library(design)
            quick = library.transfer_function
            return curves_of(quick, quantity), validity(quick, fidelity)

        return await self.in_thread("curves", work)

    async def result(self, job: Job, notify: Callable[[str], None]) -> dict[str, Any]:
        """Result of a job of any stage but that of the curves.

        Args:
            job: of the stage "points", "pinned_points", "as_built", "verdict",
                "surface", "model" or "check".
            notify: called from another thread with each line on what is being done.
        """
        stage, design = "points" if job.stage == "pinned_points" else job.stage, job.design
        key = (stage, design_key(design))
        kept = self._models if stage == "model" else self._results
        works: dict[str, tuple[str, Callable[[], dict[str, Any]]]] = {
            "points": ("points", lambda: point_figures(design)),
            "surface": ("points", lambda: membranes(design)),
            "as_built": ("as_built", lambda: self._predictor.run(as_built_figures, (design,), task=job)),
            "verdict": ("as_built", lambda: self._predictor.run(verdict_figures, (design,), task=job)),
            "model": ("cad", lambda: self.cad.run(model_of_array, (design, self._body_of(design)), task=job)),
            "check": ("cad", lambda: self.cad.run(check_figures, (design,), notify, task=job)),
        }
        thread, compute = works[stage]

        def work() -> dict[str, Any]:
            found = kept.get(key)  # of a job that was done while this one waited
            if found is None:
                found = compute()
                kept.put(key, found)
            return found

        found = kept.get(key)
        if found is not None:
            return found
        if stage == "surface":
            self._threads["touch"].submit(self._decoder.start)  # the first touch is not far
        computed: dict[str, Any] = await self.in_thread(thread, work)
        return computed

    def model_file(self, key: str) -> bytes | None:
        """The glTF of a design by its key; None where it is not kept."""
        found = self._models.get(("model", key))
        return None if found is None else found["glb"]

    def _body_of(self, design: ArrayDesign, at_hand: bool = False) -> str | None:
        """Path of the body that an array was fitted to; None where it is not known, or with ``at_hand`` not there."""
        path = self.bodies.of(design) if design.layout.frozen is not None else None
        return None if path is None or (at_hand and not path.is_file()) else str(path)

    async def keep_body(self, content: bytes, name: str) -> Path:
        """A body that a page hands in, as a file."""
        return Path(await self.in_thread("save", lambda: self.bodies.keep(content, name)))

    async def body(self, path: Path, unit: str, skin: int | None) -> dict[str, Any]:
        """A body as of :func:`studies.panels.body_panel.body_shape`, with the key of its shape as ``file``."""

        def work() -> dict[str, Any]:
            written = path.stat().st_mtime_ns if path.is_file() else 0
            key = hashlib.sha256(repr((str(path), written, unit, skin)).encode()).hexdigest()
            found = self._shapes.get(key)
            if found is None:
                found = {**self._fitter.run(body_shape, (str(path), unit, skin)), "file": f"/bodies/{key}"}
                self._shapes.put(key, found)
            return found

        return dict(await self.in_thread("fit", work))

    def shape_file(self, key: str) -> bytes | None:
        """The shape of a body by its key; None where it is not kept."""
        found = self._shapes.get(key)
        return None if found is None else found["shape"]

    async def fit(
        self, design: ArrayDesign, asked: tuple[Any, ...], notify: Callable[[str], None], task: object
    ) -> ArrayDesign:
        """A design that is fitted to a body, in a process of its own, one after the other.

        Args:
            design: its parts.
            asked: the table ``[surface]``, the points of each line or None, and the path of the body.
            notify: called with what is being done.
            task: by which :meth:`stop_apart` knows it.
        """
        surface, points, body = asked
        if self._fits:
            notify(WAITING)
        self._fits += 1
        try:
            found: ArrayDesign = await self._in_turn(
                "fit",
                lambda: self._fitter.run(fit_to_body, (design, surface, points, str(body)), notify, task),
                task,
            )
        finally:
            self._fits -= 1
        return found

    async def fitted_files(self, design: ArrayDesign) -> Path:
        """Design, places and body of a fitted array in one file, to be handed out."""

        def work() -> Path:
            with self._place() as place:
                path = place / "fitted.zip"
                write_fitted(design, self._body_of(design, at_hand=True), str(path))
                return path

        return await self.in_thread("save", work)

    async def upload(self, text: str, name: str, places: tuple[str, str] | None) -> dict[str, Any]:
        """Content of an uploaded design file, as of :func:`read_upload`; it waits for no check of a design."""
        return await self.in_thread("touch", lambda: self._decoder.run(read_upload, (text, name, places)))

    async def touch(
        self, design: ArrayDesign, kind: str, options: tuple[Any, ...], recognizer: str | None
    ) -> dict[str, Any]:
        """A simulated touch, a slide or a letter, and what the decoder makes of it.

        Args:
            design: the array.
            kind: of touch.
            options: arguments of :func:`studies.panels.simulate_slide`, :func:`studies.panels.write_letter` or
                :func:`studies.panels.simulate_touch`, behind the design.
            recognizer: folder of a recognizer of kinds; None for none.
        """
        works: dict[str, Callable[..., dict[str, Any]]] = {"slide": simulate_slide, "letter": write_letter}
        return await self._decoded(works.get(kind, simulate_touch), design, options, recognizer)

    async def _decoded(
        self,
        work: Callable[..., dict[str, Any]],
        design: ArrayDesign,
        options: tuple[Any, ...],
        model: str | None,
        report: Callable[[str], None] | None = None,
    ) -> dict[str, Any]:
        asked = (work, design, options, model)
        return await self.in_thread("touch", lambda: self._decoder.run(with_kinds, asked, report))

    async def recognizer(self, content: bytes) -> dict[str, Any]:
        """A recognizer that somebody handed in, kept in a folder of its own."""

        def work() -> dict[str, Any]:
            with self._place() as place:
                found: dict[str, Any] = self._decoder.run(store_recognizer, (content, str(place)))
                return found

        return await self.in_thread("touch", work)

    async def sound_cards(self) -> list[dict[str, Any]]:
        """Sound cards of this machine."""
        return await self.in_thread("touch", lambda: self._decoder.run(sound_cards, ()))

    async def live(self, job: Job, notify: Callable[[str], None]) -> dict[str, Any]:
        """Live input from a sound card, line by line until it is stopped; one after the other."""

        def work() -> dict[str, Any]:
            with self._process("live", "the process of the sound card") as process:
                found: dict[str, Any] = process.run(listen_live, (job.design, *job.options, None), notify, job)
                return found

        if "live" in self._processes:
            raise Refusal("another page is listening to a sound card", kind=Kind.CONFLICT, remedy="stop it there first")
        return await self._in_turn("live", work, job)

    async def replay(
        self,
        design: ArrayDesign,
        options: tuple[bytes, str, float],
        recognizer: str | None,
        notify: Callable[[str], None],
    ) -> dict[str, Any]:
        """An uploaded recording, decoded; as :func:`studies.panels.replay_recording`."""
        return await self._decoded(replay_recording, design, options, recognizer, notify)

    async def manifest_scale(self, text: str, name: str) -> float:
        """Pressure at full scale that an uploaded manifest states, Pa."""
        return float(await self.in_thread("save", lambda: manifest_scale(text, name)))

    async def export(
        self, design: ArrayDesign, name: str, fidelity: Fidelity, notify: Callable[[str], None], task: object
    ) -> Path:
        """One file of a design, made in a process of its own, one after the other."""
        asked = (fidelity, self._body_of(design, at_hand=True))
        return await self._made(lambda place: (make_export, (design, name, place, *asked)), notify, task)

    async def comparison(
        self, design: ArrayDesign, pinned: ArrayDesign, notify: Callable[[str], None], task: object
    ) -> Path:
        """Page that compares a design with the pinned one, made as other files are."""
        return await self._made(lambda place: (make_comparison, (design, pinned, place)), notify, task)

    async def _made(
        self,
        call: Callable[[str], tuple[Callable[..., str], tuple[Any, ...]]],
        notify: Callable[[str], None],
        task: object,
    ) -> Path:
        """File that a call writes into a folder, in a process of its own."""

        def work() -> Path:
            with self._place() as place, self._process("export", "the process that makes files") as process:
                return Path(process.run(*call(str(place)), notify, task))

        if "export" in self._processes:
            notify(WAITING)
        return await self._in_turn("export", work, task)

    async def save(self, design: ArrayDesign) -> Path:
        """The design file, which waits for no other file."""

        def work() -> Path:
            with self._place() as place:
                return Path(make_export(design, "design.toml", str(place), "lumped"))

        return await self.in_thread("save", work)

    async def written(self, name: str, text: str) -> Path:
        """A text in a file that is handed out."""

        def work() -> Path:
            with self._place() as place:
                write_text(place / name, text)
                return place / name

        return await self.in_thread("save", work)

    async def study(self, design: ArrayDesign, text: str, notify: Callable[[str], None], task: object) -> FoundDesigns:
        """Result of a study, run in a process of its own, one after the other; if stopped, the result so far."""

        def work() -> FoundDesigns:
            with self._process("study", "the process that runs studies") as process:
                try:
                    found: FoundDesigns = process.run(run_study, (design, text), notify, task)
                except Stopped:
                    found = process.run(study_so_far, (design, text))
                return found

        if "study" in self._processes:
            notify(WAITING)
        return await self._in_turn("study", work, task)

    async def study_so_far(self, design: ArrayDesign, text: str) -> FoundDesigns:
        """Result so far of a study that is running.

        Raises:
            Refusal: nothing is there yet.
        """
        return await self.in_thread("found", lambda: study_so_far(design, text))

    async def job_words(self) -> dict[str, Any]:
        """Choices that the dialogue of a job offers."""
        return await self.in_thread("save", job_words)

    async def proposals(
        self, name: str, asked: Mapping[str, Any], notify: Callable[[str], None], task: object
    ) -> dict[str, Any]:
        """Designs that are proposed for a job, searched in a process of its own, one search after the other."""

        def work() -> dict[str, Any]:
            with self._process("proposals", "the process that searches designs") as process:
                found: dict[str, Any] = process.run(proposals_for, (name, asked), notify, task)
                return found

        if "proposals" in self._processes:
            notify(WAITING)
        return await self._in_turn("proposals", work, task)

    async def solve(self, design: ArrayDesign, notify: Callable[[str], None], task: object) -> bool:
        """Solve a design in 3-D, in a process of its own: from then on its curves are those; True once it is done."""

        def work() -> bool:
            with self._process("solve", "the process that solves in 3-D") as process:
                self._solved.put(design_key(design), process.run(solve_curves, (design,), notify, task))
                return True

        if "solve" in self._processes:
            notify(WAITING)
        return bool(await self._in_turn("solve", work, task))

    async def study_file(self, design: ArrayDesign, text: str) -> Path:
        """A study file and its base, to be handed out."""

        def work() -> Path:
            with self._place() as place:
                path = place / "study.zip"
                write_study(design, text, path)
                return path

        return await self.in_thread("save", work)

    def remove(self, path: Path) -> None:
        """Remove a file that was made here, with what lies beside it."""
        rmtree(path.parent, ignore_errors=True)

    def stop(self, task: object) -> None:
        """Post that nobody waits for a task any more."""
        self.cad.stop(task)
        self._predictor.stop(task)

    def stop_apart(self, name: str, task: object) -> None:
        """Post that a file ("export"), a study, a search ("proposals"), a fit ("fit"), a solution ("solve") or
        listening ("live") is not wanted any more.
        """
        queued = self._queued.get(task)
        if queued is not None and queued.cancel():
            return
        process = self._fitter if name == "fit" else self._processes.get(name)
        if process is not None:
            process.stop(task, at_once=True)

    def close(self) -> None:
        """End threads and processes, and remove what was written."""
        for process in (self.cad, self._decoder, self._predictor, self._fitter, *self._processes.values()):
            process.end()
        for threads in self._threads.values():
            threads.shutdown(wait=False, cancel_futures=True)
        self._folder.cleanup()

    async def in_thread(self, name: str, work: Callable[[], Any]) -> Any:
        """Result of some work, done in the thread of a stage."""
        return await asyncio.get_running_loop().run_in_executor(self._threads[name], work)

    async def _in_turn(self, name: str, work: Callable[[], Any], task: object) -> Any:
        """As :meth:`in_thread`, of work that may be stopped also while it waits.

        Raises:
            Stopped: it was.
        """
        future = self._queued[task] = self._threads[name].submit(work)
        try:
            return await asyncio.wrap_future(future)
        except asyncio.CancelledError:
            if future.cancelled():
                raise Stopped("stopped", kind=Kind.STOPPED) from None
            raise
        finally:
            del self._queued[task]

    @contextmanager
    def _place(self) -> Iterator[Path]:
        """A folder for what is written; it goes again where that fails."""
        place = Path(mkdtemp(dir=self._folder.name))
        try:
            yield place
        except BaseException:
            rmtree(place, ignore_errors=True)
            raise

    @contextmanager
    def _process(self, name: str, title: str) -> Iterator[TaskProcess]:
        """A process for one piece of work that may be stopped."""
        self._processes[name] = TaskProcess(name=title)
        try:
            yield self._processes[name]
        finally:
            self._processes.pop(name).close()


def _import_decoder() -> None:
    """Imports for the first prediction of confusion."""
    import localize.learned.features
    import localize.signals.stimulus

    del localize


def _settle() -> None:
    _import_decoder()
    gc.freeze()  # a quarter of a million objects that stay: looked through again, they would hold up a curve


def _warm_up() -> None:
    """In the process for CAD: what the first array in three dimensions needs."""
    import cadquery
    import trimesh

    del cadquery, trimesh
