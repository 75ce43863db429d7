"""What a render host and its owner say to each other: lines of JSON, and the pictures' bytes after them.

The owner orders pictures by their numbers, rising; the host answers each with a header and the pixels. A
picture that nobody ordered is passed by, and the host says at times how far it has come.
"""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from typing import IO


@dataclass(frozen=True)
class Header:
    """What comes next from a host."""

    kind: str
    """picture: pixels follow; passing: a picture that was not ordered has been reached; looked-back: the
    program read a picture that was passed by, so that none may be; failed: text says why."""
    frame: int = 0
    size: tuple[int, int] = (0, 0)
    text: str = ""

    @property
    def length(self) -> int:
        """How many bytes follow."""
        return 3 * self.size[0] * self.size[1] if self.kind == "picture" else 0


def send(stream: IO[bytes], header: Header, pixels: bytes = b"") -> None:
    """Say a header and what follows it.

    Raises BrokenPipeError where nobody listens any more.
    """
    stream.write(json.dumps(asdict(header)).encode() + b"\n")
    stream.write(pixels)
    stream.flush()


def receive(stream: IO[bytes]) -> tuple[Header, bytes] | None:
    """The next header and what follows it; None once the other side has gone."""
    line = stream.readline()
    if not line.endswith(b"\n"):
        return None
    read = json.loads(line)
    header = Header(**read | {"size": tuple(read["size"])})
    pixels = stream.read(header.length)
    return (header, pixels) if len(pixels) == header.length else None


def order(stream: IO[bytes], frames: tuple[int, ...]) -> None:
    """Ask a host for pictures.

    Raises BrokenPipeError where it has gone.
    """
    stream.write(json.dumps(frames).encode() + b"\n")
    stream.flush()


def next_order(stream: IO[bytes]) -> tuple[int, ...]:
    """The pictures that are wanted next; none once nothing more is."""
    line = stream.readline()
    return tuple(json.loads(line)) if line.endswith(b"\n") else ()
