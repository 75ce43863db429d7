"""Renders a plan: what is missing is made, written and noted, here or by many workers."""

from __future__ import annotations

import time
from collections.abc import Iterator
from typing import Protocol

from domeshim.render.files import digest, is_made, write
from domeshim.render.maker import Made, Maker
from domeshim.render.manifest import Manifest
from domeshim.render.plan import Plan

_SAVE_EVERY = 10.0
"""Seconds between two writings of the manifest."""


class Progress(Protocol):
    """Is told how the work goes on."""

    def begun(self, total: int, done: int) -> None:
        """There are so many pictures, and so many were made before."""

    def made(self, count: int = 1) -> None:
        """So many pictures more are there."""

    def passing(self, frame: int) -> None:
        """The program has come to this picture, which is not wanted."""

    def ended(self) -> None:
        """Nothing more comes."""


class Crew(Protocol):
    """Whoever makes the pictures."""

    def make(self, plan: Plan, frames: list[int], progress: Progress) -> Iterator[Made]:
        """Make these pictures of the plan, in any order; some of them again, if many programs make them."""


class Video(Protocol):
    """What takes up the pictures in their order."""

    def go_on(self) -> None:
        """Take up the pictures that are there by now."""


class Alone:
    """One program after another, on this machine."""

    def make(self, plan: Plan, frames: list[int], progress: Progress) -> Iterator[Made]:
        """Make these pictures by rising numbers."""
        maker = Maker(plan, lasting=False)
        try:
            yield from maker.make(frames, progress.passing)
        finally:
            maker.close()


def render(plan: Plan, crew: Crew, progress: Progress, video: Video | None = None) -> Manifest:
    """Make all pictures of the plan that are not there yet, and return the manifest, which is saved.

    Raises OSError where a file cannot be written.
    """
    manifest = Manifest(plan)
    manifest.resume()
    missing = _missing(plan, manifest)
    total = len(plan.frames)
    progress.begun(total * len(plan.eyes), (total - len(missing)) * len(plan.eyes))
    manifest.save()
    saved = time.monotonic()
    twice: list[Made] = []
    try:
        if video is not None:
            video.go_on()
        for made in crew.make(plan, missing, progress):
            if made.again:
                twice.append(made)
                continue
            _keep(made, manifest)
            progress.made()
            if video is not None:
                video.go_on()
            if time.monotonic() - saved > _SAVE_EVERY:
                manifest.save()
                saved = time.monotonic()
        manifest.notes = _doubts(manifest, twice)
    finally:
        manifest.save()
        progress.ended()
    return manifest


def _doubts(manifest: Manifest, twice: list[Made]) -> list[str]:
    """What to say where a picture that was made twice came out otherwise."""
    others = [
        again.frame
        for again in twice
        if not again.error
        and again.digest != manifest.hashes.get(manifest.key(again.frame, again.eye), again.digest)
    ]
    if not others:
        return []
    return [
        f"picture {min(others)} came out differently when it was made again: the program depends on more "
        "than the clock (threads, the network, the time of day, its former pictures); render it without "
        "--workers"
    ]


def _missing(plan: Plan, manifest: Manifest) -> list[int]:
    """The pictures that are to be made; the hashes of the others are known afterwards."""
    missing = []
    for frame in plan.frames:
        paths = {manifest.key(frame, eye): plan.path(frame, eye) for eye in plan.eyes}
        if not all(is_made(path, plan) for path in paths.values()):
            missing.append(frame)
            continue
        for key, path in paths.items():
            if key not in manifest.hashes:
                found = digest(path)
                if found is None:
                    missing.append(frame)
                    break
                manifest.hashes[key] = found
    return missing


def _keep(made: Made, manifest: Manifest) -> None:
    key = manifest.key(made.frame, made.eye)
    if made.error:
        manifest.failed[key] = made.error
        return
    if made.content:
        write(manifest.plan.path(made.frame, made.eye), made.content)
    manifest.hashes[key] = made.digest
    manifest.failed.pop(key, None)
