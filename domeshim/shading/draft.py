"""A shader's text in the making: snippets below each other, and the statements of its last function.

Where each line comes from stays known, so that a driver's complaint is told with our file and its line.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

from domeshim.shading.snippets import snippet

VERSION = "#version 130"
"""The oldest with clip distances."""
LEGACY_VERSION = "#version 120"
"""OpenGL 2.1's."""


def version_for(*, legacy: bool) -> str:
    """The version line of a vertex or fragment shader; legacy: as for Recipe."""
    return LEGACY_VERSION if legacy else VERSION


@dataclass(frozen=True)
class Source:
    """A shader's text, and which snippet each stretch of its lines comes from."""

    text: str
    parts: tuple[tuple[int, str], ...]
    """(first line, snippet), rising; the snippet's own line 1 is that line of the text, counted from 1."""

    @classmethod
    def join(cls, parts: Iterable[tuple[str, str]], version: str = VERSION) -> Source:
        """Put named parts, (snippet, text), below each other, under the version line."""
        lines, starts = [version], []
        for name, text in parts:
            starts.append((len(lines) + 1, name))
            lines += text.rstrip("\n").split("\n")
        return cls("\n".join(lines) + "\n", tuple(starts))

    def place(self, line: int) -> str:
        """The snippet and its own line behind a line of the text, as in lens/equidistant.glsl:4."""
        first, name = max((part for part in self.parts if part[0] <= line), default=(1, "version"))
        return f"{name}.glsl:{line - first + 1}"


@dataclass
class Draft:
    """A shader in the making: the snippets that it needs, and the statements of its last function."""

    opening: str = "void main() {"
    snippets: list[str] = field(default_factory=list)
    statements: list[str] = field(default_factory=list)

    def need(self, name: str) -> None:
        """Put a snippet in, once."""
        if name not in self.snippets:
            self.snippets.append(name)

    def add(self, *statements: str) -> None:
        """Put statements at the end of the function."""
        self.statements.extend(statements)

    def source(self, version: str = VERSION, head: str = "") -> Source:
        """The shader's text; head: lines of the preprocessor above all else."""
        last = "\n".join([self.opening, *(f"    {s}" for s in self.statements), "}"])
        parts = [("head", head)] if head else []
        return Source.join(
            [*parts, *((name, snippet(name)) for name in self.snippets), ("main", last)], version
        )
