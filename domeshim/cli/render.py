"""domeshim render: a row of dome masters of a program."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from domeshim import startup
from domeshim.cli.settings import (
    AS_TYPED,
    FIELDS_OFF_SCREEN,
    Job,
    as_module,
    dome_options,
    in_own_colours,
    options_given,
    positive,
    timeout,
)
from domeshim.errors import OptionError
from domeshim.options import Options, settings_in_environment
from domeshim.render.plan import SUFFIXES, Plan, Reel, parse_frames
from domeshim.settings import LARGEST_SIDE
from domeshim.wording import counted

if TYPE_CHECKING:
    from domeshim.render.film import Films
    from domeshim.render.manifest import Manifest
    from domeshim.render.show import Crew

LARGEST_WHOLE, TILE = 8192, 4096
"""A picture of more pixels a side is drawn in tiles of so many."""
_LARGEST_DRAWN = 32768
_FIELDS = tuple(field for field in FIELDS_OFF_SCREEN if field != "stereo")
"""A show's --stereo is one of its own: two rows of pictures."""
_SIDE = click.IntRange(min=1, max=LARGEST_SIDE)


@click.command(context_settings=AS_TYPED)
@click.option("--check", "folder", type=click.Path(path_type=Path), help="Only look through a folder.")
@click.option("--frames", metavar="A:B", help="From picture A (1 the first) up to and with B.")
@click.option("--size", type=_SIDE, default=4096, show_default=True, help="Of the square picture, pixels.")
@click.option("--output", type=click.Path(path_type=Path, file_okay=False), help="The pictures' folder.")
@click.option("--name", help="Of the show, before the picture's number; else the program's.")
@click.option("--start", type=click.IntRange(min=0), help="The first file's number; else picture A's own.")
@click.option("--format", "suffix", type=click.Choice(SUFFIXES), default="png", show_default=True)
@click.option("--fps", **positive(60.0))
@click.option("--supersample", type=click.IntRange(1, 8), default=1, show_default=True,
              help="Draw so many times as large, and average.")  # fmt: skip
@click.option(
    "--tile",
    type=click.IntRange(min=64, max=LARGEST_SIDE),
    help=f"Draw each picture in squares of so many pixels; {TILE} if it is over {LARGEST_WHOLE}.",
)
@click.option("--stereo", is_flag=True, help="Two eyes, in the folders L and R.")
@click.option("--video", type=click.Path(path_type=Path, dir_okay=False),
              help="A film of the pictures as well: .mp4, .mov or .webm.")  # fmt: skip
@click.option("--workers", type=click.IntRange(min=1), help="So many processes on this machine, by Dask.")
@click.option("--cluster", metavar="ADDRESS", help="The workers of a running Dask scheduler.")
@click.option("--chunk", type=click.IntRange(min=1), default=24, show_default=True,
              help="Pictures that a worker makes at a time.")  # fmt: skip
@timeout(120.0)
@dome_options(_FIELDS)
@as_module
@click.argument("prog", required=False)
@click.argument("args", nargs=-1, type=click.UNPROCESSED)
def render(folder: Path | None, prog: str | None, args: tuple[str, ...], **given: Any) -> Job:
    """Render a program's pictures as dome masters, without a display, on a clock that counts frames.

    Square, the front at the bottom edge, HUD off unless asked for. What is already in the folder is not made
    again, so an interrupted run goes on where it stopped. --check DIR finds missing, broken or differing
    pictures.
    """
    if folder is not None:
        return partial(_check, folder)
    for option in ("frames", "output"):
        if not given[option]:
            raise OptionError(f"--{option} is missing; domeshim render --help says what it takes")
    if prog is None:
        raise OptionError("no program to render; give PROG after the options")
    plan = _plan(prog, args, given)
    return partial(_render, plan, _crew(given), given["video"])


def _plan(prog: str, args: tuple[str, ...], given: dict[str, Any]) -> Plan:
    """The plan that the options make.

    Raises OptionError.
    """
    first, last = parse_frames(given["frames"])
    module, size = given["module"], given["size"]
    if not module and not Path(prog).exists():
        raise OptionError(f"cannot render {prog}: no such file")
    side = size * given["supersample"]
    if side > _LARGEST_DRAWN:
        raise OptionError(f"--supersample: {side} pixels would have to be drawn; at most {_LARGEST_DRAWN}")
    fields = {field: given[field] for field in _FIELDS if given[field] is not None}
    settings = {"hud": "off", "preset": "domemaster", **settings_in_environment(), **fields}
    if "config" in settings:
        settings["config"] = str(Path(settings["config"]).absolute())
    options = in_own_colours(options_given(True, settings), "render")  # said here, not by a worker
    reel = Reel(
        prog if module else str(Path(prog).absolute()),
        args,
        module,
        settings,
        side,
        given["fps"],
        given["timeout"],
    )
    start = given["start"]
    return Plan(
        reel,
        first,
        last,
        size,
        given["output"].absolute(),
        given["name"] or Path(prog).stem,
        given["suffix"],
        0 if start is None else start - first,
        ("left", "right") if given["stereo"] else ("",),
        _tile(given, side, options),
    )


def _tile(given: dict[str, Any], side: int, options: Options) -> int:
    """How large the tiles are, as they are drawn; 0 for none.

    Raises OptionError for what is made of whole pictures only.
    """
    wanted = given["tile"] or (TILE if side > LARGEST_WHOLE else 0)
    if not 0 < wanted < side:
        return 0
    for field, whole in (
        ("stereo", options.stereo not in ("off", "left", "right")),
        ("surface", options.surface[0] in ("mesh", "cylinder")),
        ("mirror", options.mirror != "off"),
        ("hud", options.flat_hud),
        ("method", options.cubemap and side > LARGEST_WHOLE),
    ):
        if whole:
            raise OptionError(
                f"--{field} is not to be had in tiles; {side} pixels would be drawn by --tile={wanted}"
            )
    times: int = given["supersample"]
    return max(wanted // times, 1) * times


def _crew(given: dict[str, Any]) -> Crew:
    """Who makes the pictures."""
    from domeshim.render.show import Alone  # noqa: PLC0415 - with what it takes to render

    workers, cluster = given["workers"], given["cluster"]
    if workers and cluster:
        raise OptionError("--workers and --cluster: give one of them")
    if not workers and not cluster:
        return Alone()
    try:
        from domeshim.render.farm import Farm  # noqa: PLC0415 - an extra
    except ImportError as error:
        hint = "install Dask with: pip install 'domeshim[farm]'"
        raise OptionError(f"--workers and --cluster: {error.name} is not installed; {hint}") from None
    return Farm(workers or 0, cluster, given["chunk"])


def _films(video: Path, plan: Plan) -> Films:
    """The film to be made.

    Raises OptionError.
    """
    try:
        from domeshim.render.film import Films  # noqa: PLC0415 - an extra
    except ImportError as error:
        hint = "install PyAV with: pip install 'domeshim[movie]'"
        raise OptionError(f"--video: {error.name} is not installed; {hint}") from None
    return Films(video.absolute(), plan)


def _render(plan: Plan, crew: Crew, video: Path | None) -> None:
    from domeshim.render.progress import Bar  # noqa: PLC0415 - with what it takes to render
    from domeshim.render.show import render as render_show  # noqa: PLC0415 - as above

    films = _films(video, plan) if video is not None else None
    try:
        manifest = render_show(plan, crew, Bar(plan.name), films)
    except OSError as error:
        raise OptionError(f"--output={plan.output}: {error.strerror or error}") from None
    except KeyboardInterrupt:
        startup.say("stopped; the same command goes on from here")
        raise SystemExit(130) from None
    finally:
        if films is not None and not films.close():
            startup.say(f"{films.path} was not written: pictures are missing")
    _tell(manifest)


def _tell(manifest: Manifest) -> None:
    """Say what could not be made, and end with status 1 where something could not."""
    for note in manifest.notes:
        startup.say(note)
    wanted = manifest.wanted
    failed = {key: reason for key, reason in manifest.failed.items() if key in wanted}
    for key, reason in list(failed.items())[:5]:
        startup.say(f"{key}: {reason}")
    if failed:
        lacking = counted(len(failed), "picture")
        startup.say(f"{lacking} could not be made; {manifest.path} names them all")
    if failed or manifest.notes:
        raise SystemExit(1)


def _check(folder: Path) -> None:
    from domeshim.render.manifest import Manifest  # noqa: PLC0415 - Pillow comes with it

    manifest = Manifest.load(folder)
    wrong = manifest.complaints()
    for key, complaint in wrong.items():
        click.echo(f"{key}: {complaint}")
    total = len(manifest.keys)
    click.echo(f"as they were rendered: {total - len(wrong)} of {counted(total, 'picture')}")
    if wrong:
        click.echo("remove what is wrong, and the same domeshim render makes it again")
        raise SystemExit(1)
