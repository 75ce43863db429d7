"""domeshim bench: how far off each method is, and how long it takes."""

from __future__ import annotations

import json
import os
from pathlib import Path

import click

from domeshim.cli.settings import AS_TYPED, as_module, dome_options, options_given, parse_window_size, timeout
from domeshim.errors import OptionError
from domeshim.extras import require

_FIELDS = ("fov", "lens")


def _sizes(_context: click.Context, _parameter: click.Parameter, text: str) -> tuple[int, ...]:
    sizes = [parse_window_size("--size", part) for part in text.split(",")]
    if any(width != height for width, height in sizes):
        raise OptionError(
            f"--size={text}: accepted: the side of a square picture, pixels; several as in 512,1024"
        )
    return tuple(width for width, _ in sizes)


@click.command(context_settings=AS_TYPED)
@click.option(
    "--scene", "names", multiple=True, help="One of the bench's scenes; may be repeated. All of them."
)
@click.option(
    "--size",
    "sizes",
    default="1024",
    show_default=True,
    callback=_sizes,
    help="Pixels each way; several as in 512,1024.",
)
@click.option(
    "--method",
    "methods",
    multiple=True,
    help="As DOME_METHOD; may be repeated. All, cubemap at three face sizes.",
)
@click.option("--tolerance", default="0.1,0.5,2,8", show_default=True, help="Pixels; several for a curve.")
@click.option(
    "--rounds", type=click.IntRange(min=3), default=15, show_default=True, help="Pictures of each, in turns."
)
@click.option(
    "--edges", type=click.IntRange(min=1), default=24, show_default=True, help="Edges of each scene to judge."
)
@click.option(
    "--output",
    type=click.Path(path_type=Path, file_okay=False),
    help="A folder for bench.md, bench.json and the plot, bench.png.",
)
@click.option("--peers/--no-peers", default=True, help="VTK's panoramic pass as well, if vtk is installed.")
@click.option("--json", "as_json", is_flag=True, help="Print JSON instead of tables.")
@click.option("--quick", is_flag=True, help="512 pixels, 5 rounds, 8 edges.")
@timeout()
@as_module
@dome_options(_FIELDS)
@click.argument("prog", required=False)
@click.argument("args", nargs=-1, type=click.UNPROCESSED)
def bench(
    names: tuple[str, ...],
    sizes: tuple[int, ...],
    methods: tuple[str, ...],
    tolerance: str,
    rounds: int,
    edges: int,
    output: Path | None,
    peers: bool,
    as_json: bool,
    quick: bool,
    timeout: float,
    module: bool,
    prog: str | None,
    args: tuple[str, ...],
    **given: str | None,
) -> int:
    """Measure error against run time on this machine's GL, without a display.

    The bench's own scenes by each method: a method's picture takes turns with the monitor's picture by stock
    PyOpenGL, in one process; errors are against the truth in float64. With PROG, that program instead: its
    pictures take turns as well, in processes of their own, and errors are what domeshim compare finds.
    """
    require("scipy", "measure", "domeshim bench")
    if output is not None:
        require("matplotlib", "plot", "the plot of domeshim bench")
    options = options_given(True, given)
    os.environ["PYOPENGL_PLATFORM"] = "egl"  # before OpenGL is imported
    from domeshim.bench.scenes import SCENES  # noqa: PLC0415 - once the options are known to be good
    from domeshim.bench.tournament import Wish, program_tournament, tournament  # noqa: PLC0415
    from domeshim.measure.apart import Program  # noqa: PLC0415

    known = {scene.name: scene for scene in SCENES}
    for name in names:
        if name not in known:
            raise OptionError(f"--scene={name}: not known; accepted: {', '.join(known)}")
    scenes = [known[name] for name in dict.fromkeys(names or known)]
    care = (5, 8) if quick else (rounds, edges)
    wish = Wish(options, (512,) if quick else sizes, methods, tolerance, *care, peers)
    if prog is not None and names:
        raise OptionError(f"--scene={names[0]}: {prog} is measured instead; accepted: one of the two")
    if prog is None:
        results = tournament(scenes, wish)
    else:
        settings = {field: text for field, text in given.items() if text is not None}
        results = program_tournament(Program(prog, args, module, timeout=timeout), wish, settings)
    click.echo(json.dumps(results.as_json(), indent=2) if as_json else results.markdown(), nl=False)
    if output is not None:
        from domeshim.bench.files import write  # noqa: PLC0415

        write(results, output)
    return 0
