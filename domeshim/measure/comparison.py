"""Runs a program as on the monitor and on the dome, each in a process of its own, and compares the pictures.

The dome's picture is taken so large that an angle has as many pixels in it as on the monitor: a line is a
pixel wide in both, and a letter as high.
"""

from __future__ import annotations

import tempfile
from collections.abc import Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path

import numpy as np
from PIL import Image

from domeshim.measure.apart import NoExposureError, Program, run_apart
from domeshim.measure.difference import Difference, Verdict, difference, same_picture, unwarped
from domeshim.measure.exposures import Exposure, Wanted
from domeshim.measure.match import Mask, Picture

LARGEST_DOME = 4096
"""The most pixels a side of the dome's picture gets."""
LARGEST_FINER = 6144
"""The same where details of a texture ask for more."""


@dataclass(frozen=True)
class Run:
    """The pictures of one run by number, and what domeshim said of what it cannot do exactly."""

    exposures: Mapping[int, Exposure]
    notes: tuple[str, ...]


@dataclass(frozen=True)
class Compared:
    """One picture of a program, of one size, on the monitor and on the dome."""

    frame: int
    size: tuple[int, int]
    difference: Difference
    monitor: Picture | None = None
    dome: Picture | None = None
    """As it is on the dome."""
    seen_as_monitor: Picture | None = None
    """The dome's picture as the program's window would show it."""
    perspective: bool = False
    renderer: str = ""
    notes: tuple[str, ...] = ()

    @property
    def verdict(self) -> Verdict:
        """Alike, different or undecided."""
        return self.difference.verdict


PLAIN = {
    "stereo": "off",
    "surface": "dome",
    "mirror": "off",
    "fade": "0",
    "brightness": "1",
    "gamma": "1",
    "debug": "off",
}
"""Settings that leave the dome's picture as it is drawn: one eye's, in its colours, not a projector's."""


@dataclass(frozen=True)
class Comparison:
    """Compares pictures of these numbers, 1 the first, of one window's size; settings as in Wanted.

    The dome's picture is judged before it is finished for two eyes, another surface or a projector.
    """

    program: Program
    frames: tuple[int, ...] = (1,)
    size: tuple[int, int] = (512, 512)
    settings: Mapping[str, str] = field(default_factory=dict)

    def results(self) -> Iterator[Compared]:
        """One for each picture, in their order."""
        try:
            for frame in self.frames:
                yield self._compared(frame)
        except NoExposureError as error:
            for frame in self.frames:
                yield self._undecided(frame, str(error))

    def _compared(self, frame: int) -> Compared:
        monitor, again = (run.exposures[frame].picture for run in self._monitors)
        run = self._dome
        dome = run.exposures[frame]
        result = Compared(
            frame,
            self.size,
            UNKNOWN,
            monitor,
            dome.picture,
            None,
            dome.perspective,
            dome.renderer,
            run.notes,
        )
        reason = ""
        if not same_picture(monitor, again):
            reason = "the program shows another picture at each run, on the monitor too"
        elif dome.places is None or dome.seen is None:
            reason = "the program's own GL is not bent onto the dome"
        elif abs(dome.seen.shape[0] / dome.seen.shape[1] - monitor.shape[0] / monitor.shape[1]) > 0.01:
            reason = "the program's window has another shape on the dome"
        if reason:
            return replace(result, difference=replace(UNKNOWN, reason=reason))
        flat, seen = _as_on_monitor(dome, monitor.shape[1::-1])
        apart = difference(monitor, flat, seen)
        if apart.verdict == "different" and (finer := self._apart_in_detail(frame)) is not None:
            grows = finer.seen > apart.seen / 2  # else the program's view is of one size in any window
            apart = finer if grows and finer.verdict != "different" else apart
        if apart.verdict == "different" and dome.overlaid:
            apart = replace(apart, verdict="undecided", reason=OVERLAID)
        return replace(result, seen_as_monitor=flat, difference=apart)

    def _apart_in_detail(self, frame: int) -> Difference | None:
        """The difference of both pictures taken twice as large and scaled down; None where that is too large.

        Details of a texture that are about a pixel wide break up in either picture, and then no more.
        """
        try:
            if self._finer is None:
                return None
        except NoExposureError:
            return None
        monitor, dome = (run.exposures[frame] for run in self._finer)
        small = np.asarray(Image.fromarray(monitor.picture).reduce(2))
        return replace(difference(small, *_as_on_monitor(dome, small.shape[1::-1])), finer=True)

    def _undecided(self, frame: int, reason: str) -> Compared:
        return Compared(frame, self.size, replace(UNKNOWN, reason=reason))

    @cached_property
    def _first_runs(self) -> tuple[Run, Run, Run]:
        """Twice as on the monitor, and once on a small dome, which tells how large it should be."""
        with ThreadPoolExecutor(3) as workers:
            first, second = (workers.submit(self.take, dome=False) for _ in range(2))
            small = workers.submit(self.take, dome=True, side=min(self.size), frames=self.frames[:1])
            return first.result(), second.result(), small.result()

    @property
    def _monitors(self) -> tuple[Run, Run]:
        return self._first_runs[:2]

    @cached_property
    def _dome(self) -> Run:
        return self._of_side(self._side)

    def _of_side(self, side: int) -> Run:
        """The dome's pictures, of so many pixels: in a larger window where the program's own is the frame."""
        run = self.take(dome=True, side=side)
        if all(min(exposure.picture.shape[:2]) == side for exposure in run.exposures.values()):
            return run
        width, height = (round(each * side / min(self.size)) for each in self.size)
        return replace(self, size=(width, height)).take(dome=True)

    @cached_property
    def _finer(self) -> tuple[Run, Run] | None:
        """As on the monitor and on the dome, both twice as large."""
        twice = replace(self, size=(2 * self.size[0], 2 * self.size[1]))
        side = 2 * self._side
        return (twice.take(dome=False), twice._of_side(side)) if side <= LARGEST_FINER else None

    @property
    def _side(self) -> int:
        small = self._first_runs[2].exposures[self.frames[0]]
        return min(self.size) if small.places is None else even_side(small, LARGEST_DOME)

    def take(
        self,
        *,
        dome: bool,
        side: int | None = None,
        frames: tuple[int, ...] | None = None,
        plain: bool = True,
    ) -> Run:
        """Run the program for its pictures; side: of the dome's frame, pixels; plain: not finished further.

        Raises NoExposureError.
        """
        settings = {**self.settings, **(PLAIN if plain else {})} if dome else {}
        if side is not None:
            settings["frame"] = f"{side}x{side}"
        program, frames = self.program, frames or self.frames
        with tempfile.TemporaryDirectory() as folder:
            wanted = Wanted(
                folder, frames, self.size, dome, settings, program.module, program.fps, program.timeout
            )
            files = {frame: f"{frame}.npz" for frame in frames}
            notes = run_apart(program, "domeshim.measure.exposures", wanted, list(files.values()))
            return Run({frame: Exposure.load(Path(folder) / name) for frame, name in files.items()}, notes)


OVERLAID = "the program draws over each other what it sees in several perspectives"
UNKNOWN = Difference("undecided", "", 0, 0, 0, 0, None)
"""Nothing was compared."""


def _as_on_monitor(dome: Exposure, size: tuple[int, ...]) -> tuple[Picture, Mask]:
    """The dome's picture as a window of this size would show it, and where it can be seen."""
    assert dome.places is not None
    assert dome.seen is not None
    places = dome.places if dome.channels is None else dome.channels
    flat, seen = unwarped(dome.picture, places, dome.seen), dome.seen
    if flat.shape[1::-1] == size:
        return flat, seen
    width, height = size
    whole = Image.fromarray(seen.astype(np.uint8) * 255).resize((width, height), Image.Resampling.BOX)
    return np.asarray(Image.fromarray(flat).resize((width, height), Image.Resampling.BOX)), np.asarray(
        whole
    ) == 255


def even_side(exposure: Exposure, largest: int) -> int:
    """How many pixels wide the dome must be for an angle to have as many as on the monitor, in the median."""
    assert exposure.places is not None
    assert exposure.seen is not None
    places, seen = exposure.places.astype(float), exposure.seen
    right = (places[1:-1, 2:] - places[1:-1, :-2]) / 2
    down = (places[2:, 1:-1] - places[:-2, 1:-1]) / 2
    area = np.abs(right[..., 0] * down[..., 1] - right[..., 1] * down[..., 0])
    whole = seen[1:-1, 2:] & seen[1:-1, :-2] & seen[2:, 1:-1] & seen[:-2, 1:-1] & (area > 0)
    side: int = min(exposure.picture.shape[:2])
    if not whole.any():
        return side
    even = round(side / float(np.sqrt(np.median(area[whole]))))
    return max(16, min(even, largest))
