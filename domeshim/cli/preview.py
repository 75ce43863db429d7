"""domeshim preview: a virtual dome on the desk."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from domeshim import startup
from domeshim.cli.settings import AS_TYPED, Job, as_module, options_given, positive, size
from domeshim.errors import DomeError, OptionError
from domeshim.options import settings_in_environment
from domeshim.program import run_program
from domeshim.session import Session
from domeshim.wording import counted

if TYPE_CHECKING:
    from domeshim.preview.dome import VirtualDome
    from domeshim.preview.pictures import Picture
    from domeshim.preview.viewer import Viewer

_PICTURES = (".png", ".tif", ".tiff", ".jpg", ".jpeg")


def numbers(_context: click.Context, parameter: click.Parameter, text: str) -> tuple[float, ...]:
    """The callback of an option that takes numbers with commas, as many as its default has."""
    wanted = str(parameter.default).count(",") + 1
    try:
        found = tuple(float(part) for part in text.split(","))
    except ValueError:
        found = ()
    if len(found) != wanted:
        raise OptionError(f"{parameter.opts[0]}={text}: accepted: {wanted} numbers with commas between them")
    return found


@click.command(context_settings=AS_TYPED)
@click.option("--output", type=click.Path(path_type=Path, dir_okay=False), help="Write a PNG file instead.")
@click.option("--size", default="960x640", show_default=True, callback=size, help="Of the view, S or WxH.")
@click.option("--dome-radius", **positive(8.0), help="Metres.")
@click.option(
    "--dome-tilt", type=float, help="Degrees that the dome leans to the front; else as for the program."
)
@click.option(
    "--rim", type=float, default=2.0, show_default=True, help="Height of the dome's centre, metres."
)
@click.option("--at", default="0,1.2,-2.5", show_default=True, callback=numbers,
              help="The viewer: to the right, up, to the front; metres.")  # fmt: skip
@click.option("--look", default="0,35", show_default=True, callback=numbers,
              help="Degrees to the right of the front, and up.")  # fmt: skip
@click.option("--angle", type=click.FloatRange(10, 130), default=75.0, show_default=True, help="Of the view.")
@click.option("--fps", **positive(30.0), help="Of a folder's pictures.")
@click.option("--frame", type=click.IntRange(min=1), default=1, show_default=True, help="With --output.")
@as_module
@click.argument("what", metavar="PROG|PICTURE|DIR")
@click.argument("args", nargs=-1, type=click.UNPROCESSED)
def preview(what: str, args: tuple[str, ...], **given: Any) -> Job:
    """Show a program, a dome picture or a folder of them on a virtual dome.

    Drag to look around, W A S D E Q fly, the wheel zooms, R goes back to the seat. A program shows its own
    window as well, and goes by the DOME_* variables as a dome master does.
    """
    settings: dict[str, str] = {"preset": "domemaster", **settings_in_environment()}
    options = options_given(True, settings)
    path = Path(what)
    from domeshim.preview.dome import dome_of  # noqa: PLC0415 - numpy
    from domeshim.preview.viewer import Viewer  # noqa: PLC0415

    lean = {} if given["dome_tilt"] is None else {"tilt": given["dome_tilt"]}
    dome = dome_of(options, radius=given["dome_radius"], rim=given["rim"], **lean)
    right, up, ahead = given["at"]
    heading, pitch = given["look"]
    viewer = Viewer((right, up, -ahead), heading, pitch, given["angle"])
    still = not given["module"] and (path.is_dir() or path.suffix.lower() in _PICTURES)
    if given["output"] is not None:
        take = partial(_first, path) if still else partial(_taken, what, args, settings, given)
        return partial(_write, take, dome, viewer, given)
    if still:
        return partial(_show, path, dome, viewer, given)
    session = Session(options_given(True, settings | {"preview": "1"}))
    session.virtual_dome = dome
    session.viewer = viewer

    def job() -> None:
        startup.run_under(session)
        run_program(what, args, module=given["module"])

    return job


def _files(path: Path) -> list[Path]:
    from domeshim.preview.pictures import pictures_in  # noqa: PLC0415 - numpy

    return pictures_in(path) if path.is_dir() else [path]


def _show(path: Path, dome: VirtualDome, viewer: Viewer, given: dict[str, Any]) -> None:
    from domeshim.preview.pictures import Files, read_picture  # noqa: PLC0415

    files = _files(path)
    read_picture(files[0])  # what is wrong with it is said before a window opens
    from domeshim.preview.window import show_dome  # noqa: PLC0415 - glfw and GL

    show_dome(Files(files, given["fps"]), dome, viewer, given["size"])


def _write(take: Any, dome: VirtualDome, viewer: Viewer, given: dict[str, Any]) -> None:
    from PIL import Image  # noqa: PLC0415 - for those who write pictures

    from domeshim.preview.still import view  # noqa: PLC0415

    seen = view(take(given["frame"]), dome, viewer, given["size"])
    try:
        Image.fromarray(seen).save(given["output"], format="PNG")
    except OSError as error:
        raise OptionError(f"--output={given['output']}: {error.strerror or error}") from None


def _first(path: Path, frame: int) -> Picture:
    from domeshim.preview.pictures import read_picture  # noqa: PLC0415

    files = _files(path)
    if frame > len(files):
        raise OptionError(f"--frame={frame}: {path} has {counted(len(files), 'picture')}")
    return read_picture(files[frame - 1])


def _taken(
    prog: str, args: tuple[str, ...], settings: dict[str, str], given: dict[str, Any], frame: int
) -> Picture:
    """A program's picture, taken off screen."""
    import numpy as np  # noqa: PLC0415

    from domeshim.render.hosted import Host, LooksBackError  # noqa: PLC0415
    from domeshim.render.plan import Reel  # noqa: PLC0415

    module = given["module"]
    if not module and not Path(prog).exists():
        raise OptionError(f"cannot show {prog}: no such file")
    host = Host(Reel(prog if module else str(Path(prog).absolute()), args, module, settings), draws_all=True)
    try:
        header, pixels = next(host.pictures((frame,), lambda _frame: None))
    except LooksBackError as error:
        raise DomeError(str(error)) from None
    finally:
        host.close()
    width, height = header.size
    return np.frombuffer(pixels, np.uint8).reshape(height, width, 3)
