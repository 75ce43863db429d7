"""Pictures as files: each appears under its name only when it is whole, and says of which plan it is."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Sequence
from pathlib import Path

from domeshim.render.plan import Plan

Tile = tuple[tuple[int, int], bytes]
"""Width and height, and so many RGB pixels, a byte each, the top row first."""
_MARK = "domeshim"
_DESCRIPTION = 270
"""TIFF's ImageDescription."""


def encode(tiles: Sequence[Tile], plan: Plan) -> tuple[bytes, str]:
    """A picture file's content, and the SHA-256 of the pixels that it shows.

    tiles: of all the plan's parts, in their order. What is drawn larger than the plan's picture is made
    smaller by averaging.
    """
    from io import BytesIO  # noqa: PLC0415 - with Pillow

    from PIL import Image, PngImagePlugin  # noqa: PLC0415 - only who makes pictures needs it

    times = plan.reel.side // plan.size

    def shown(tile: Tile) -> Image.Image:
        image = Image.frombytes("RGB", *tile)
        return image if times == 1 else image.reduce(times)

    if plan.parts == (None,):
        image = shown(tiles[0])
    else:
        image = Image.new("RGB", (plan.size, plan.size))
        for part, tile in zip(plan.parts, map(shown, tiles), strict=True):
            left, bottom, *_ = part or (0, 0)
            image.paste(tile, (left // times, plan.size - bottom // times - tile.height))
    content, mark = BytesIO(), f"{_MARK} {plan.fingerprint}"
    if plan.suffix == "png":
        info = PngImagePlugin.PngInfo()
        info.add_text("Software", mark)
        image.save(content, format="PNG", pnginfo=info, compress_level=1)
    else:
        image.save(content, format="TIFF", compression="tiff_lzw", tiffinfo={_DESCRIPTION: mark})
    return content.getvalue(), hashlib.sha256(image.tobytes()).hexdigest()


def write(path: Path, content: bytes) -> None:
    """Write a file that appears under its name only when it is whole.

    Raises OSError.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    unfinished = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        with unfinished.open("wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        unfinished.replace(path)
    finally:
        unfinished.unlink(missing_ok=True)


def is_made(path: Path, plan: Plan) -> bool:
    """The file is there and of this plan; only its head is read."""
    from PIL import Image  # noqa: PLC0415 - only who makes pictures needs it

    try:
        with Image.open(path) as image:
            said = image.info.get("Software") if plan.suffix == "png" else image.getexif().get(_DESCRIPTION)
            return said == f"{_MARK} {plan.fingerprint}" and image.size == (plan.size, plan.size)
    except OSError:
        return False


def digest(path: Path) -> str | None:
    """The SHA-256 of a picture's pixels; None where the file is not a whole picture.

    Raises FileNotFoundError.
    """
    from PIL import Image  # noqa: PLC0415 - only who makes pictures needs it

    try:
        with Image.open(path) as image:
            return hashlib.sha256(image.convert("RGB").tobytes()).hexdigest()
    except FileNotFoundError:
        raise
    except (OSError, SyntaxError, ValueError):  # what Pillow raises for a broken file
        return None
