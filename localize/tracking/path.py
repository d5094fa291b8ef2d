"""Paths of contacts over the surface, from the decisions of a stream.

A path goes from the first hop in which a contact is detected to the last one before a pause. A contact that lies still,
or is between membranes, is not detected, so a short pause does not end a path.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import scipy.ndimage
from numpy.typing import NDArray

from acoustic_fem import Library
from geometry.ground.figures import new_figure
from geometry.ground.shown import Shown
from geometry.ground.typed import Array
from localize.live.events import Decision, TrackedPlace
from localize.live.stream_options import HIGH_PASS, MOVING
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.noise_model import NoiseChoice
from localize.signals.threads import one_thread
from localize.tracking.footprints import footprints_over, pitch_of, pressure_of_force
from localize.tracking.moving import STEP, MovingScorer, ScoredHop
from localize.tracking.smoothing import HOP_TIME, Cells, smoothed
from localize.tracking.tracking_options import TrackingOptions

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True, eq=False, repr=False)
class Track(Shown):
    """Path of one contact, a row for every 16 ms."""

    def shown(self) -> tuple[str, Mapping[str, object]]:
        """Title and facts that a session and a notebook show."""
        seen = self.detected
        if not seen.any():
            return "Path", {"contact": "none detected"}
        length = float(np.hypot(*np.diff(self.place[seen], axis=0).T).sum())
        return "Path", {
            "time": f"{self.time[seen][0]:.3g} to {self.time[seen][-1]:.3g} s",
            "length": f"{length:.3g} mm",
            "standard deviation of the place": f"{np.median(self.deviation[seen]):.2g} mm, as the median",
            "speed": f"{np.median(self.speed[seen]):.3g} mm/s, as the median",
        }

    def plot(self) -> Figure:
        """Figure of the path in plan, mm, coloured by time, where the contact is detected.

        Raises:
            MissingExtra: matplotlib is not installed.
        """
        figure = new_figure(6.4, 4.4)
        axes = figure.subplots()
        axes.plot(*self.place.T, color="#cccccc", linewidth=1)
        x, y = self.place[self.detected].T
        dots = axes.scatter(x, y, c=self.time[self.detected], cmap="viridis", s=14, zorder=2)
        figure.colorbar(dots, ax=axes, label="time  (s)")
        axes.set(xlabel="x  (mm)", ylabel="y  (mm)", aspect="equal")
        return figure

    time: Array
    """Times, s; (n,) float64."""
    place: Array
    """Middle of the contact in the plan of :attr:`localize.ArrayResponse.position`; (n, 2) float64, mm."""
    deviation: Array
    """Standard deviation of the place in each direction; (n,) float64, mm."""
    speed: Array
    """Speed; (n,) float64, mm/s."""
    force: Array
    """Force on the membranes as far as it changes faster than the high-pass of the stream, by the membranes of the
    design; (n,) float64, N; not a number where no contact is detected."""
    detected: NDArray[np.bool_]
    """True where the contact is detected; between, the path goes on from one membrane to the next; (n,) bool."""
    pitch: float
    """Distance of the points of the array, mm."""


class PathTracker:
    """Tracker of paths from the decisions of a stream with ``StreamOptions(frames=True)``.

    Args:
        library: with a design, as of :class:`localize.BayesDecoder`.
        contact_radius_mm: radius of the contact, mm.
        microphone_noise: as of :class:`localize.BayesDecoder`.
        ambient: level of room sound, dB SPL; None for a quiet room.
        high_pass: that of the stream, Hz; None for none.
        options: numbers that tune the tracker.

    Raises:
        Refusal: bare transfer functions; a radius out of range; as :class:`localize.BayesDecoder`.
    """

    @one_thread()
    def __init__(
        self,
        library: Library | ArrayResponse,
        contact_radius_mm: float = MOVING,
        microphone_noise: NoiseChoice = "design",
        ambient: float | None = None,
        high_pass: float | None = HIGH_PASS,
        options: TrackingOptions = TrackingOptions(),
    ) -> None:
        self.options = options
        self.response = response = response_of(library)
        """Array on which the paths are."""
        footprints = footprints_over(response, contact_radius_mm, options.most_footprints, options.footprints)
        self._scorer = MovingScorer(response, footprints, microphone_noise, ambient, high_pass, options)
        self.pitch = pitch_of(response)
        """Distance of the points, mm."""
        self._cells = Cells.of(footprints, self.pitch, options)
        inside = (response.frequency >= options.force_band[0]) & (response.frequency <= options.force_band[1])
        # The source is given along fractions of norm 1; their sum is the force on the membranes.
        self._newtons = footprints.fraction.sum(1) / float(pressure_of_force(response)[inside].mean())
        self.tracks: list[Track] = []
        """Paths that have ended."""
        self._begin()

    def _begin(self) -> None:
        self._belief = np.full(len(self._cells.middle), 1 / len(self._cells.middle))
        self._times: list[float] = []
        self._hops: list[ScoredHop] = []
        self._silent = 0

    @one_thread()
    def take(self, event: object) -> list[TrackedPlace]:
        """Place of the contact after the next event of a stream; empty for events that are not decisions."""
        if not isinstance(event, Decision):
            return []
        time = event.time - self.options.latency
        if self._times and not 0 < time - self._times[-1] < 1.5 * HOP_TIME:
            self._end()
            self._scorer.reset()
        if event.frame is None:
            count = len(self._cells.middle)
            hop = ScoredHop(np.zeros(count), np.zeros(count), np.zeros(count))
        else:
            hop = self._scorer.score(event.frame)
        heard = float(hop.gain.max()) > self.options.detection_lead
        if not self._times and not heard:
            self._scorer.decide(hop.power * 0)
            return []
        self._belief = self._cells.forward(self._belief, STEP / self.options.ahead * hop.gain)
        self._scorer.decide(self._belief * hop.power)
        self._times.append(time)
        self._hops.append(hop)
        self._silent = 0 if heard else self._silent + 1
        if self._silent * HOP_TIME > self.options.pause:
            self._end()
            return []
        if not heard:
            return []
        middle = self._belief @ self._cells.middle
        away = ((self._cells.middle - middle) ** 2).sum(1) / 2 + self._cells.extent**2
        deviation = float(np.sqrt(self._belief @ away))
        return [TrackedPlace(time, (float(middle[0]), float(middle[1])), deviation, self.options.latency)]

    def finish(self) -> list[TrackedPlace]:
        """End the path that the stream ends in, if there is one; always empty, because the end adds no place."""
        self._end()
        return []

    def _end(self) -> None:
        if self._times:
            track = self._track(np.array(self._times), self._hops)
            if track is not None:
                self.tracks.append(track)
        self._begin()

    def _track(self, time: Array, hops: list[ScoredHop]) -> Track | None:
        """Path of the hops of a contact; None for a few hops that are detected by chance."""
        gain, power, source = (np.stack([getattr(hop, name) for hop in hops]) for name in ("gain", "power", "source"))
        belief = self._cells.forward_backward(STEP / self.options.ahead * gain)
        amplitude = np.sqrt((belief * power).sum(1))
        near, wide = (scipy.ndimage.maximum_filter1d(amplitude, round(2 * each / HOP_TIME)) for each in (0.25, 1.0))
        heard = (belief * gain).sum(1) > self.options.detection_lead
        heard &= (amplitude > self.options.faint * near) & (amplitude > self.options.faintest * wide)
        if heard.sum() < self.options.fewest_hops:
            return None
        place = belief @ self._cells.middle
        apart = ((self._cells.middle[None] - place[:, None]) ** 2).sum(2) / 2
        # A membrane is pressed less the farther its middle is.
        off = 2 * (belief @ self._cells.extent) * (1 - amplitude / np.maximum(near, 1e-300))
        sure = np.minimum(self.options.place_deviation * self.pitch, belief @ self._cells.extent)
        # Frames of neighbouring hops share what they hear.
        deviation = np.sqrt(self.options.ahead / STEP * ((sure + off) ** 2 + (belief * apart).sum(1)))
        ends = slice(int(heard.argmax()), len(heard) - int(heard[::-1].argmax()))
        place, deviation, speed = smoothed(place[ends], np.where(heard, deviation, np.inf)[ends], self.options)
        force = np.where(heard, (belief * source * self._newtons).sum(1), np.nan)
        return Track(time[ends], place, deviation, speed, force[ends], heard[ends], self.pitch)
