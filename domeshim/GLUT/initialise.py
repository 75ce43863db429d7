"""glutInit and what the next window shall be like."""

from __future__ import annotations

import re
from typing import Any

from domeshim import session as sessions
from domeshim.GLUT import constants as c
from domeshim.GLUT.arguments import callback, integer, text
from domeshim.GLUT.complaints import fatal
from domeshim.GLUT.state import GlutState, glut_state
from domeshim.wording import counted

_GEOMETRY = re.compile(r"=?(?:(\d+)[xX](\d+))?(?:([+-]-?\d+)([+-]-?\d+))?")
_MODE_WORDS = {
    "alpha": c.GLUT_ALPHA,
    "acca": c.GLUT_ACCUM,
    "acc": c.GLUT_ACCUM,
    "depth": c.GLUT_DEPTH,
    "double": c.GLUT_DOUBLE,
    "index": c.GLUT_INDEX,
    "single": c.GLUT_SINGLE,
    "stencil": c.GLUT_STENCIL,
    "stereo": c.GLUT_STEREO,
    "samples": c.GLUT_MULTISAMPLE,
    "rgb": c.GLUT_RGB,
    "rgba": c.GLUT_RGBA | c.GLUT_ALPHA,
    "luminance": c.GLUT_LUMINANCE,
}
_IGNORED_MODE_WORDS = frozenset(
    {"auxbufs", "blue", "borderless", "buffer", "conformant", "green", "num", "red", "slow", "win32pfd"}
    | {"xvisual", "xstaticgray", "xgrayscale", "xstaticcolor", "xpseudocolor", "xtruecolor", "xdirectcolor"}
)


def glutInit(*args: Any) -> Any:
    """Start GLUT; takes nothing, a list of arguments, or several, and returns those left, as bytes.

    -geometry WxH+X+Y, -iconic, -display NAME, -direct, -indirect, -gldebug and -sync are taken out. A second
    call changes nothing and returns what it was given, as PyOpenGL's does.
    """
    state = glut_state()
    if state.initialised:
        return args
    words = _words(args) or ["foo"]
    state.program = words[0].rsplit("/", 1)[-1]
    left = _without_options(state, words)
    state.initialised = True
    state.began = sessions.current().clock.now()
    return [word.encode() for word in left]


def _words(args: tuple[Any, ...]) -> list[str]:
    """Return the words of PyOpenGL's three ways to call glutInit: nothing, (count, *words) or words."""
    if args and isinstance(args[0], int):
        count, args = args[0], args[1:]
        if count != len(args):
            raise ValueError(f"glutInit: {counted(count, 'argument')} announced, {len(args)} given")
    elif args and not isinstance(args[0], str | bytes):
        args = tuple(args[0])
    return [text("glutInit", "argument", word if isinstance(word, bytes) else str(word)) for word in args]


def _without_options(state: GlutState, words: list[str]) -> list[str]:
    left, rest = words[:1], iter(words[1:])
    for word in rest:
        if word == "-geometry":
            _take_geometry(state, next(rest, ""))
        elif word == "-display":
            name = next(rest, "")
            state.say_once(f"-display {name} is left to the DISPLAY variable")
        elif word == "-iconic":
            state.iconic = True
        elif word not in ("-direct", "-indirect", "-gldebug", "-sync"):
            left.append(word)
    return left


def _take_geometry(state: GlutState, geometry: str) -> None:
    found = _GEOMETRY.fullmatch(geometry)
    if not geometry or found is None:
        fatal(state.program, f"-geometry must be followed by WIDTHxHEIGHT+X+Y, not by {geometry!r}.")
    width, height, x, y = found.groups()
    if width:
        state.init_size = (int(width), int(height))
    if x:
        state.init_position = (int(x), int(y))


def glutInitDisplayMode(displayMode: Any, *_more: object) -> None:
    """Say what the next windows' frame buffers hold: GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH and the like."""
    state = glut_state()
    state.display_mode = integer("glutInitDisplayMode", "displayMode", displayMode)
    state.samples = 4
    _mention_index_mode(state)


def glutInitDisplayString(displayMode: Any, *_more: object) -> None:
    """Say the same in words: "rgb double depth>=16 samples~4"."""
    state = glut_state()
    mode = 0
    for word in text("glutInitDisplayString", "displayMode", displayMode).replace(",", " ").split():
        found = re.fullmatch(r"([a-z0-9]+)(?:(?:[<>!]=|[<>=~])(\d+))?", word)
        name = found[1] if found else word
        if name in _MODE_WORDS:
            wanted = not (found and found[2] == "0")
            mode |= _MODE_WORDS[name] if wanted else 0
            if name == "samples" and found and found[2]:
                state.samples = int(found[2])
        elif name not in _IGNORED_MODE_WORDS:
            state.warn(f"glutInitDisplayString(): {word!r} is no display mode")
    state.display_mode = mode
    _mention_index_mode(state)


def _mention_index_mode(state: GlutState) -> None:
    if state.display_mode & c.GLUT_INDEX:
        state.say_once("colour-index windows do not exist any more; this one gets red, green and blue")


def glutInitWindowSize(width: Any, height: Any, *_more: object) -> None:
    """Give the next windows' size in pixels."""
    state = glut_state()
    state.init_size = (
        integer("glutInitWindowSize", "width", width),
        integer("glutInitWindowSize", "height", height),
    )


def glutInitWindowPosition(x: Any, y: Any, *_more: object) -> None:
    """Give the next windows' place; negative numbers leave it to the window manager."""
    state = glut_state()
    state.init_position = (
        integer("glutInitWindowPosition", "x", x),
        integer("glutInitWindowPosition", "y", y),
    )


def glutInitContextVersion(majorVersion: Any, minorVersion: Any, *_more: object) -> None:
    """Note the GL version wanted; a compatibility context of the highest version is what one gets."""
    state = glut_state()
    state.context["major"] = integer("glutInitContextVersion", "majorVersion", majorVersion)
    state.context["minor"] = integer("glutInitContextVersion", "minorVersion", minorVersion)


def glutInitContextFlags(flags: Any, *_more: object) -> None:
    """Note the context flags wanted; GLUT_FORWARD_COMPATIBLE is not granted."""
    state = glut_state()
    state.context["flags"] = integer("glutInitContextFlags", "flags", flags)
    if state.context["flags"] & c.GLUT_FORWARD_COMPATIBLE:
        state.say_once("a forward-compatible context was asked for; this one is a compatibility context")


def glutInitContextProfile(profile: Any, *_more: object) -> None:
    """Note the profile wanted; a compatibility context, which can do all that a core one can, is given."""
    state = glut_state()
    state.context["profile"] = integer("glutInitContextProfile", "profile", profile)
    if state.context["profile"] & c.GLUT_CORE_PROFILE:
        state.say_once("a core-profile context was asked for; this one is a compatibility context")


def glutInitErrorFunc(function: Any) -> None:
    """Let the program itself tell of fatal misuse: function(words, None), after which it ends."""
    glut_state().on_error = callback("glutInitErrorFunc", function)


def glutInitWarningFunc(function: Any) -> None:
    """Let the program itself tell of other misuse: function(words, None)."""
    glut_state().on_warning = callback("glutInitWarningFunc", function)
