"""Layout of a WAV file: where its format and its samples lie, also where recorders left a header that is not true.

A recorder that writes to a pipe, or that dies, leaves lengths of 0, of 2 GB or of 4 GB, or of its last update. Others
leave out the pad byte after a chunk of odd length, count eight bytes too many, or write a second chunk of samples. If
all samples are there, they are read, and a note says so.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import IO, Any, Literal

from geometry.ground.refusal import Kind, Refusal

_MAGIC = (b"RIFF", b"RIFX", b"RF64", b"BW64")
_MOST_CHUNKS = 1000
#: Lengths from here on, and beyond the end of the file, mean that the recorder did not know the length: arecord states
#: 7FFFF000, SoX 7FFFFFFF, FFmpeg FFFFFFFF.
_UNKNOWN = 0x7FFF0000
#: Bytes by which the stated length of a file may be too large: the header of RIFF counted in, and a pad byte.
_COUNTED_IN = 9
#: Samples behind those that are stated are read if they last at least so long, s, or are half as many as these.
_FEWEST_SECONDS = 0.1
#: Names of chunks of samples, formats and what recorders add, to tell a chunk from samples.
_NAMES = frozenset(
    b"fmt |data|fact|LIST|INFO|bext|iXML|JUNK|junk|PAD |FLLR|PEAK|cue |plst|labl|note|smpl|inst|ID3 |id3 |ds64|axml|"
    b"chna|cart|aXML|umid|minf|elm1|regn|olym|acid|strc|link|Fake|afsp|DISP|_PMX|SAUR|SNDM|TIME|wamd|guan".split(b"|")
)


@dataclass
class WavLayout:
    """Places of what a WAV file holds."""

    order: Literal["big", "little"]
    """Order of bytes."""
    format: bytes = b""
    """Content of the chunk of the format."""
    pieces: list[tuple[int, int]] = field(default_factory=list)
    """First byte and number of bytes of each piece of the samples."""
    notes: list[str] = field(default_factory=list)
    """Faults of the header, each as a clause that follows the name of the file."""
    is_regular: bool = True
    """True if a reader that believes the header finds all samples."""

    @property
    def frame(self) -> int:
        """Bytes of one sample of all channels."""
        return int.from_bytes(self.format[12:14], self.order)

    def rewritten(self, file: IO[bytes]) -> bytes:
        """The same samples as a WAV file with a true header.

        Args:
            file: of which the layout is.
        """
        samples = bytearray()
        for place, length in self.pieces:
            file.seek(place)
            samples += file.read(length)
        del samples[len(samples) - len(samples) % max(self.frame, 1) :]
        chunks = b"fmt " + len(self.format).to_bytes(4, self.order) + self.format
        chunks += b"data" + len(samples).to_bytes(4, self.order) + bytes(samples)
        return (
            (b"RIFX" if self.order == "big" else b"RIFF") + (4 + len(chunks)).to_bytes(4, self.order) + b"WAVE" + chunks
        )


def wav_layout(path: Path, refusal: type[Refusal]) -> WavLayout:
    """Layout of a WAV file.

    Args:
        path: of the file.
        refusal: class of the errors.

    Raises:
        Refusal: by ``refusal``: not a WAV file, or samples that its header states are not there.
    """
    with path.open("rb") as file:
        return _Reader(path, file, refusal).layout()


class _Reader:
    def __init__(self, path: Path, file: IO[bytes], refusal: type[Refusal]) -> None:
        self._path, self._file, self._refusal = path, file, refusal
        self._size = path.stat().st_size
        self._long_data: int | None = None  # number of bytes of samples by the chunk ds64

    def layout(self) -> WavLayout:
        """Layout of the file."""
        head = self._bytes(0, 12)
        if len(head) < 12 or head[:4] not in _MAGIC or head[8:] != b"WAVE":
            raise self._fault("is cut short or not a WAV file")
        found = WavLayout("big" if head[:4] == b"RIFX" else "little", is_regular=head[:4] != b"BW64")
        end = int.from_bytes(head[4:8], found.order) + 8
        for name, place, length in self._chunks(12, found):
            if name == b"ds64":
                self._long_data = int.from_bytes(self._bytes(place + 8, 8), "little")
                end = int.from_bytes(self._bytes(place, 8), "little") + 8
            elif name == b"fmt " and not found.format:
                found.format = self._bytes(place, min(length, 1000))
            elif name == b"data":
                found.pieces.append((place, length))
        if len(found.format) < 16 or not found.pieces:
            raise self._fault(
                "is cut short or not a WAV file: it has no samples; recorders that are stopped at once leave this"
            )
        unknown = end - 8 >= _UNKNOWN or end == 8
        if self._size + _COUNTED_IN < end and not unknown and not found.notes:
            raise self._cut(end)
        if end != self._size and not found.notes and (unknown or end > self._size + self._size % 2):
            self._note(found, "states a length that is not its own; all of its samples are there and are read")
        self._join(found)
        return found

    def _chunks(self, place: int, found: WavLayout) -> Iterator[tuple[bytes, int, int]]:
        """Name, first byte and length of each chunk, of samples the length that is there."""
        for _ in range(_MOST_CHUNKS):
            if place + 8 > self._size:
                return
            name, length = self._chunk(place, found)
            if name not in _NAMES and not _is_name(name):
                if not found.pieces:
                    raise self._fault("is cut short or not a WAV file")
                return
            place += 8
            if name == b"data":
                length = self._samples(place, length, found)
            elif place + length > self._size:
                if not found.pieces:
                    raise self._cut(place + length)
                if name in _NAMES:
                    self._note(found, "is cut off behind its samples, which are all there and are read")
                return
            yield name, place, length
            place = self._behind(place + length, length, found)
        raise self._fault("is cut short or not a WAV file: it has no end of chunks")

    def _samples(self, place: int, stated: int, found: WavLayout) -> int:
        """Number of bytes of samples from a place on, which may not be what is stated."""
        if stated == 0xFFFFFFFF and self._long_data:
            stated = self._long_data
        there = self._size - place
        unknown = stated >= _UNKNOWN and stated > there
        if stated > there and not unknown:
            raise self._cut(place + stated)
        if unknown or (stated == 0 and there >= 8 and not self._is_chain(place, found)):
            self._note(found, "does not state how many samples it has; all that are there are read")
            return there
        rest = there - stated
        if stated == 0 or rest <= 8 or self._is_chain(place + stated + stated % 2, found):
            return stated
        if self._is_chain(place + stated, found):
            return stated
        behind = self._bytes(place + stated, rest)
        if behind.startswith(b"TAG") or not behind.strip(b"\0"):
            return stated  # a title of the old kind, or room that was not used
        if rest < min(stated / 2, _FEWEST_SECONDS * int.from_bytes(found.format[8:12], found.order)):
            return stated  # too few to be what a recorder has left out of its header: of a write that was cut off
        self._note(
            found,
            f"states {stated} bytes of samples and holds {there}; all are read, because recorders that are cut off "
            "leave such headers",
        )
        return there

    def _behind(self, place: int, length: int, found: WavLayout) -> int:
        """Place of the next chunk; recorders may leave out the pad byte behind an odd length."""
        if length % 2 == 0:
            return place
        if self._bytes(place + 1, 4) not in _NAMES and self._bytes(place, 4) in _NAMES:
            self._note(found, "has a chunk of odd length without a pad byte; its samples are read")
            return place
        return place + 1

    def _is_chain(self, place: int, found: WavLayout) -> bool:
        """True if chunks with possible names begin at a place and end with the file."""
        for _ in range(_MOST_CHUNKS):
            if place >= self._size - 1:
                return True
            if place + 8 > self._size:
                return False
            name, length = self._chunk(place, found)
            if name not in _NAMES and not _is_name(name):
                return False
            place += 8 + length
            if place > self._size + 1:
                return name in _NAMES  # what is missing is looked at where it is read
            place += 0 if self._bytes(place, 4) in _NAMES else length % 2
        return False

    def _join(self, found: WavLayout) -> None:
        """Say what several chunks of samples, and a part of a sample at the end, are taken for."""
        found.pieces = [each for each in found.pieces if each[1]] or found.pieces[:1]
        if len(found.pieces) > 1:
            self._note(found, f"has {len(found.pieces)} chunks of samples; they are read one after the other")
        rest = sum(length for _, length in found.pieces) % max(found.frame, 1)
        if rest:
            self._note(found, f"ends within a sample; its last {rest} bytes are left out")

    def _note(self, found: WavLayout, text: str) -> None:
        found.notes.append(text)
        found.is_regular = False

    def _chunk(self, place: int, found: WavLayout) -> tuple[bytes, int]:
        head = self._bytes(place, 8)
        return head[:4], int.from_bytes(head[4:], found.order)

    def _bytes(self, place: int, count: int) -> bytes:
        self._file.seek(place)
        return self._file.read(count)

    def _cut(self, end: int) -> Refusal:
        return self._fault(
            f"is cut short: it has {self._size} of {end} bytes; the recorder was stopped, the disk was full, or the "
            "copy is not whole"
        )

    def _fault(self, problem: str, **facts: Any) -> Refusal:
        return self._refusal(problem, kind=Kind.UNREADABLE, file=self._path, **facts)


def _is_name(name: bytes) -> bool:
    """True for four letters, digits or blanks, of which the first two are no blanks."""
    return (
        len(name) == 4
        and name[:2].isalnum()
        and all(byte == 32 or chr(byte).isalnum() for byte in name)
        and name.isascii()
    )
