"""What can go wrong, one tree.

DomeError                 anything domeshim itself reports
├── OptionError           a DOME* variable or command option is malformed (exit status 2)
├── ScreenError           no window and no off-screen surface could be had
├── DriverError           this machine's GL lacks something that is needed
└── ShaderError           the driver refused a shader; quotes its words with our file and line

ProgramFinished           not an error: ends the user's program once its last wanted frame is taken
"""

from __future__ import annotations


class DomeError(Exception):
    """Anything that domeshim itself reports; its text is one clear line for the user."""

    exit_status = 1


class OptionError(DomeError):
    """A DOME* variable or a command's option is malformed; names it, its value and what is accepted."""

    exit_status = 2


class ScreenError(DomeError):
    """Neither a window nor an off-screen surface could be opened; says what was tried and what to install."""


class DriverError(DomeError):
    """This machine's GL lacks something that the call needs; names it and what was found."""


class ShaderError(DomeError):
    """The driver refused a shader; quotes its words with the snippet's file and line."""


class ProgramFinished(SystemExit):
    """Ends the user's program from inside: the last wanted frame has been taken."""
