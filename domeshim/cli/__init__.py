"""The domeshim command: one file a command, imported when it is called."""

from __future__ import annotations

import sys
from importlib import import_module

import click

from domeshim import __version__, startup
from domeshim.errors import DomeError

COMMANDS = ("run", "capture", "compare", "bench", "render", "preview", "lens", "explain", "doctor")
"""The commands in the order of --help. Each is a module of this folder, and a function of its name there."""


class _Commands(click.Group):
    """The commands by name; only the one that is called is imported."""

    def list_commands(self, ctx: click.Context) -> list[str]:  # noqa: ARG002 - click's own signature
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:  # noqa: ARG002
        if cmd_name not in COMMANDS:
            return None
        command = getattr(import_module(f"domeshim.cli.{cmd_name}"), cmd_name)
        assert isinstance(command, click.Command)
        return command


@click.command(cls=_Commands, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, message="%(prog)s %(version)s")
def commands() -> None:
    """Existing PyOpenGL programs on a planetarium dome, without a changed line.

    Each command also hears the DOME_* variables.
    """


def main() -> None:
    """Run the domeshim command with the process's arguments, and end the process with its exit status."""
    try:
        job = commands.main(args=sys.argv[1:] or ["--help"], prog_name="domeshim", standalone_mode=False)
        if callable(job):
            job()
        elif job:
            sys.exit(job)
    except click.ClickException as error:
        startup.say(error.format_message())
        sys.exit(error.exit_code)
    except DomeError as error:
        startup.say(str(error))
        sys.exit(error.exit_status)
