"""dome.toml: the settings of a dome in a file, by the variables' names."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from difflib import get_close_matches
from pathlib import Path

from domeshim.errors import OptionError


def read_config(path: Path, asked: str, names: Mapping[str, str]) -> dict[str, tuple[str, str]]:
    """The settings in a file, as setting: (where it stands, its text).

    A key is a variable's name, with or without DOME_, in any case. asked: where the user named the file;
    names: the setting of each variable. Raises OptionError in one line, with the file and the line.
    """
    try:
        text = path.read_text("utf-8-sig")
        table = tomllib.loads(text)
    except (UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise OptionError(f"{path}: not TOML: {error}") from None
    except (OSError, ValueError) as error:  # a ValueError for what can be no file's name
        reason = error.strerror if isinstance(error, OSError) else error
        raise OptionError(f"{asked}={str(path)!r}: {reason}; accepted: a dome.toml") from None
    found: dict[str, tuple[str, str]] = {}
    for key, value in table.items():
        place = f"{path}:{_line_of(key, text)}: {key}"
        variable = key.upper() if key.upper().startswith("DOME_") else f"DOME_{key.upper()}"
        setting = names.get(variable)
        if setting is None:
            raise OptionError(f"{place}: no such setting{_meant(variable, names)}")
        if setting in found:
            raise OptionError(f"{place}: said before, by {found[setting][0]}")
        found[setting] = place, _text(value, place)
    return found


def _text(value: object, place: str) -> str:
    """A value as a variable would have it."""
    match value:
        case bool():
            return str(int(value))
        case str() | int() | float():
            return str(value)
        case list() if value and all(isinstance(v, int | float) and not isinstance(v, bool) for v in value):
            return ",".join(map(str, value))
    raise OptionError(f"{place}: a {type(value).__name__}; accepted: a string, a number, a list of numbers")


def _line_of(key: str, text: str) -> int:
    found = re.search(rf"^[ \t]*\[?[ \t]*[\"']?{re.escape(key)}\b", text, re.MULTILINE)
    return text.count("\n", 0, found.end()) + 1 if found else 1


def _meant(variable: str, names: Mapping[str, str]) -> str:
    close = get_close_matches(variable, names, n=1, cutoff=0.7)
    if close:
        return f"; probably meant: {names[close[0]]}"
    return f"; accepted: {', '.join(sorted(names.values()))}"
