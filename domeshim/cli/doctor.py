"""domeshim doctor: what this machine's OpenGL can do, and what a program asks of a dome."""

from __future__ import annotations

import json
import textwrap
from collections.abc import Iterator, Sequence
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

import click

from domeshim.cli.settings import AS_TYPED, as_json, as_module, in_own_colours, options_given, timeout

if TYPE_CHECKING:
    from domeshim.diagnosis.findings import Finding
    from domeshim.diagnosis.machine import Trial

_WIDTH = 100


@click.command(context_settings=AS_TYPED)
@click.option("--frame", type=click.IntRange(min=1), default=1, show_default=True, help="PROG's picture.")
@as_json
@timeout()
@as_module
@click.argument("prog", required=False)
@click.argument("args", nargs=-1, type=click.UNPROCESSED)
def doctor(
    prog: str | None, args: tuple[str, ...], module: bool, frame: int, as_json: bool, timeout: float
) -> int:
    """Tell what this machine's OpenGL can do; with PROG, what that asks for that a dome shows otherwise.

    Exit status 1 where nothing can be drawn at all, or PROG gives no picture.
    """
    from domeshim.diagnosis.findings import findings  # noqa: PLC0415 - numpy and more, for this command alone
    from domeshim.diagnosis.machine import methods, screens  # noqa: PLC0415
    from domeshim.measure.apart import NoExposureError, Program  # noqa: PLC0415

    in_own_colours(options_given(True, {}), "doctor")  # a malformed variable is told before anything runs
    tried = screens()
    off_screen = any(trial.name == "offscreen" and trial.works for trial in tried)
    ways = methods() if off_screen else []
    found: list[Finding] = []
    why = "nothing can be drawn off screen" if prog and not off_screen else ""
    if prog and off_screen:
        try:
            found = findings(Program(prog, args, module, timeout=timeout), frame, {})
        except NoExposureError as error:
            why = str(error)
    if as_json:
        told: dict[str, Sequence[Any]] = {"screens": tried, "methods": ways, "program": found}
        click.echo(json.dumps({name: [asdict(each) for each in these] for name, these in told.items()}))
    else:
        click.echo("\n".join([*_machine(tried, ways), *(_program(prog, found, why) if prog else [])]))
    return 1 if why or not any(trial.works for trial in tried) else 0


def _machine(tried: Sequence[Trial], ways: Sequence[Trial]) -> Iterator[str]:
    for trial in tried:
        name = {"window": "on the screen", "offscreen": "off screen"}[trial.name]
        yield f"{name}: {'yes' if trial.works else 'no'}"
        if trial.words:
            yield from _wrapped("  ", trial.words)
        if trial.found:
            yield f"  {trial.found['renderer']} ({trial.found['vendor']}), by {trial.found['backend']}"
            yield f"  OpenGL {trial.found['version']}; GLSL {trial.found['glsl']}"
            limits = ", ".join(f"{name} {value}" for name, value in trial.found["limits"].items())
            yield f"  {limits}"
            missing = [name for name, there in trial.found["extensions"].items() if not there]
            if missing:
                yield from _wrapped("  without ", ", ".join(missing))
    if ways:
        yield "methods, tried off screen:"
    for trial in ways:
        lead = f"  {trial.name:<11} {'yes' if trial.works else 'no':<4} "
        yield from _wrapped(lead, trial.words) or [lead.rstrip()]


def _program(prog: str, found: Sequence[Finding], why: str) -> Iterator[str]:
    yield f"{prog}:"
    if why:
        yield from _wrapped("  ", why)
    elif not found:
        yield "  nothing that would mean something else on a dome was seen"
    for finding in found:
        yield from _wrapped(f"  {finding.sure:<8} ", finding.words)


def _wrapped(lead: str, text: str) -> list[str]:
    return textwrap.wrap(text, _WIDTH, initial_indent=lead, subsequent_indent=" " * len(lead))
