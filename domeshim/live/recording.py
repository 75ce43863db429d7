"""A film of what is seen, made in a thread: pictures faster than it encodes are dropped and counted."""

from __future__ import annotations

import os
from fractions import Fraction
from importlib import import_module
from pathlib import Path
from queue import Full, Queue
from threading import Thread
from typing import Any

from domeshim.errors import OptionError
from domeshim.extras import require
from domeshim.live.readback import Picture

_TICK = Fraction(1, 1000)
_QUEUED = 8
"""So many pictures may wait to be encoded."""
_IN_PARTS = {"movflags": "frag_keyframe+empty_moov"}
"""What was written can be played even if the program is killed."""
_X264 = ("libx264", {"preset": "veryfast", "crf": "18", "bf": "0"}, _IN_PARTS)
_KINDS: dict[str, tuple[str, dict[str, str], dict[str, str]]] = {
    ".mp4": _X264,
    ".mov": _X264,
    ".webm": ("libvpx-vp9", {"deadline": "realtime", "cpu-used": "8", "crf": "18", "b": "0"}, {}),
}
"""Codec, its options, and the container's, by the file's suffix."""


def check_film(path: Path) -> None:
    """Raise OptionError for a file that no film can be written to, MissingExtraError without PyAV."""
    if path.suffix.lower() not in _KINDS:
        raise OptionError(
            f"DOME_RECORD={path}: not a kind of video known here; accepted: {', '.join(_KINDS)}"
        )
    if not path.absolute().parent.is_dir() or not os.access(path.absolute().parent, os.W_OK):
        raise OptionError(
            f"DOME_RECORD={path}: cannot be written; accepted: a file in a folder that is there"
        )
    require("av", "movie", "recording")


class Recording:
    """One film, each picture at its own time."""

    def __init__(self, path: Path) -> None:
        """Raises OptionError where the file cannot be written."""
        check_film(path)
        import_module("av")  # here and not in the thread: a program may end while it is being imported
        self.path = path
        self.taken = 0
        self.dropped = 0
        """Pictures that came while too many waited."""
        self.error = ""
        """Why it ended early."""
        self._queue: Queue[Picture | None] = Queue(_QUEUED)
        self._thread = Thread(target=self._work, name="domeshim recording", daemon=True)
        self._thread.start()

    def add(self, picture: Picture) -> None:
        """Take up a picture; returns at once."""
        try:
            self._queue.put_nowait(picture)
        except Full:
            self.dropped += 1

    def close(self) -> None:
        """Wait for what is left to be encoded, and end the film."""
        self._queue.put(None)
        self._thread.join()

    def _work(self) -> None:
        try:
            self._write()
        except Exception as error:  # whatever the encoder finds: the program must go on
            self.error = str(error)
            while self._queue.get() is not None:
                self.dropped += 1

    def _write(self) -> None:
        import av  # noqa: PLC0415 - an extra, and slow to import

        first = self._queue.get()
        if first is None:
            return
        codec, options, container_options = _KINDS[self.path.suffix.lower()]
        with av.open(str(self.path), "w", options=container_options) as film:
            stream: Any = film.add_stream(codec, rate=60, options=options)
            stream.width, stream.height = (side - side % 2 for side in first.size)
            stream.pix_fmt = "yuv420p"
            stream.codec_context.time_base = _TICK
            picture: Picture | None = first
            tick = -1
            while picture is not None:
                frame = av.VideoFrame.from_ndarray(picture.bgra.copy(), format="bgra")
                frame = frame.reformat(stream.width, stream.height, "yuv420p")
                tick = max(tick + 1, round((picture.time - first.time) / float(_TICK)))
                frame.pts, frame.time_base = tick, _TICK
                film.mux(stream.encode(frame))
                self.taken += 1
                picture = self._queue.get()
            film.mux(stream.encode())
