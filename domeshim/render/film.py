"""Rendered pictures become a video, in their order, as soon as each is there."""

from __future__ import annotations

import os
from fractions import Fraction
from pathlib import Path
from typing import Any

import av
from PIL import Image

from domeshim.errors import OptionError
from domeshim.render.plan import Plan

CODECS = {".mp4": "libx264", ".mov": "libx264", ".webm": "libvpx-vp9"}
_QUALITY = {"crf": "18"}


class Film:
    """One eye's pictures of a plan as a video, which appears under its name when it is whole."""

    def __init__(self, path: Path, plan: Plan, eye: str = "") -> None:
        """Raises OptionError where the file cannot be written, or its suffix stands for no video."""
        codec = CODECS.get(path.suffix.lower())
        if codec is None:
            raise OptionError(
                f"--video={path}: not a kind of video known here; accepted: {', '.join(CODECS)}"
            )
        if plan.size % 2:
            raise OptionError(f"--video: its pictures need an even --size, not {plan.size}")
        self._path = path
        self._unfinished = path.with_name(f".{os.getpid()}.{path.name}")
        self._plan = plan
        self._eye = eye
        self._next = plan.first
        try:
            self._container: Any = av.open(str(self._unfinished), "w")
        except OSError as error:
            raise OptionError(f"--video={path}: {error.strerror or error}") from None
        self._stream = self._container.add_stream(
            codec, rate=Fraction(plan.reel.fps).limit_denominator(1001), options=_QUALITY
        )
        self._stream.width = self._stream.height = plan.size
        self._stream.pix_fmt = "yuv420p"

    def go_on(self) -> None:
        """Take up all pictures that follow the last one and are there by now."""
        while self._next <= self._plan.last:
            path = self._plan.path(self._next, self._eye)
            if not path.exists():
                return
            with Image.open(path) as image:
                frame = av.VideoFrame.from_image(image.convert("RGB"))
            self._container.mux(self._stream.encode(frame))
            self._next += 1

    def close(self) -> bool:
        """End the video; False where pictures are missing, and it was thrown away."""
        whole = self._next > self._plan.last
        if whole:
            self._container.mux(self._stream.encode())
        self._container.close()
        if whole:
            self._unfinished.replace(self._path)
        self._unfinished.unlink(missing_ok=True)
        return whole


class Films:
    """A plan's videos: NAME for one eye, NAME-L and NAME-R for two."""

    def __init__(self, path: Path, plan: Plan) -> None:
        """Raises OptionError as Film does."""
        suffixes = {"": "", "left": "-L", "right": "-R"}
        self.path = path
        self._films = [Film(path.with_stem(path.stem + suffixes[eye]), plan, eye) for eye in plan.eyes]

    def go_on(self) -> None:
        """Take up the pictures that are there by now."""
        for film in self._films:
            film.go_on()

    def close(self) -> bool:
        """End the videos; False where pictures are missing."""
        ended = [film.close() for film in self._films]
        return all(ended)
