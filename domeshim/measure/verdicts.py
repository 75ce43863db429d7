"""What domeshim compare says: a report for each picture, as text and as JSON."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from domeshim import __version__
from domeshim.errors import OptionError
from domeshim.measure.apart import Program
from domeshim.measure.baseline import Baseline
from domeshim.measure.comparison import Compared
from domeshim.measure.difference import STATUS, Difference, Verdict
from domeshim.measure.match import SHIFT
from domeshim.measure.sheet import write_sheet

_GRAVITY: tuple[Verdict, ...] = ("alike", "undecided", "different")
_WORDS: dict[Verdict, str] = {"alike": "alike", "different": "different", "undecided": "could not tell"}


@dataclass(frozen=True)
class Report:
    """One picture's comparison with the monitor, and with the stored picture where one is asked for."""

    name: str
    result: Compared
    stored: Difference | None = None
    update: Path | None = None
    """Where the dome's picture was stored just now."""
    sheet: Path | None = None
    """The picture that shows the comparison."""

    @property
    def verdict(self) -> Verdict:
        """Different if anything is, else undecided if anything is."""
        verdicts = [self.result.verdict, *([self.stored.verdict] if self.stored is not None else [])]
        return max(verdicts, key=_GRAVITY.index)

    @staticmethod
    def status(reports: Sequence[Report]) -> int:
        """The exit status of them all."""
        return STATUS[max((report.verdict for report in reports), key=_GRAVITY.index)]

    def text(self) -> str:
        """A few lines to be read."""
        width, height = self.result.size
        found = self.result.difference
        head = f"{self.name}, picture {self.result.frame}, {width}x{height}: {_WORDS[found.verdict]}"
        lines = [f"{head}: {found.reason}" if found.reason else head]
        if found.seen:
            lines += _figures(found, "seen by both", "of the program's window")
        if found.finer:
            lines.append("  both taken twice as large and scaled down, for details of textures")
        if found.loose:
            lines.append("  lines, points and text are as wide in pixels on the dome: held loosely")
        if self.result.dome is not None:
            side = "x".join(str(side) for side in self.result.dome.shape[1::-1])
            how = "" if self.result.perspective else ", through the panel: it sets no perspective"
            lines.append(f"  dome                 {side}{how}")
        if self.stored is not None:
            reason = f": {self.stored.reason}" if self.stored.reason else ""
            lines.append(f"  the stored picture   {_WORDS[self.stored.verdict]}{reason}")
        lines += [f"  stored               {self.update}"] if self.update else []
        lines += [f"  note                 {note}" for note in self.result.notes]
        lines += [f"  picture              {self.sheet}"] if self.sheet else []
        return "\n".join(lines)

    def as_json(self) -> dict[str, Any]:
        """All that is known, for other programs."""
        result = self.result
        return {
            "program": self.name,
            "frame": result.frame,
            "size": list(result.size),
            "verdict": self.verdict,
            "monitor": asdict(result.difference),
            "stored": asdict(self.stored) if self.stored is not None else None,
            "perspective": result.perspective,
            "dome": list(result.dome.shape[1::-1]) if result.dome is not None else None,
            "notes": list(result.notes),
            "picture": str(self.sheet) if self.sheet else None,
            "renderer": result.renderer,
            "domeshim": __version__,
        }


def judged(result: Compared, program: Program, baseline: Baseline | None, output: Path | None) -> Report:
    """The report on a comparison; writes its picture where one is wanted.

    Raises OptionError where a file cannot be written.
    """
    name = Path(program.prog).stem if not program.module else program.prog
    report = Report(name, result)
    if baseline is not None:
        stored = baseline.held(name, result)
        report = Report(name, result, stored, baseline.path(name, result) if stored is None else None)
    if output is None or result.monitor is None:
        return report
    width, height = result.size
    path = output / f"{name}-{result.frame}-{width}x{height}.png"
    try:
        write_sheet(path, result, report.text().splitlines()[0])
    except OSError as error:
        raise OptionError(f"--output={output}: {error.strerror or error}; accepted: a folder") from None
    return Report(name, result, report.stored, report.update, path)


def _figures(found: Difference, seen: str, of: str) -> list[str]:
    lines = [
        f"  {seen:<20} {found.seen:.0%} {of}",
        f"  wrong pixels         {found.wrong:.2%} ({found.wrong_of_content:.2%} of the content),"
        f" more than {SHIFT} pixels off",
        f"  mean difference      {found.mean:.2f} of 255",
    ]
    moved = found.moved
    if moved is None:
        lines.append("  displacement         too little to be seen for a figure")
    else:
        lines.append(
            f"  displacement         {moved.largest:.2f} pixels at most (+- {moved.error:.2f}),"
            f" scale {moved.scale:+.2%}"
        )
    return lines
