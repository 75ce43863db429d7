"""What domeshim compare says of known faults: writes the table in docs/compare.md.

    python benchmarks/sensitivity.py

Every program's right dome is compared, and then the same with one fault. A dome that is wrong by an angle is
drawn with that setting and judged as if it had not been; a wrong scene is another scene on the dome than on
the monitor.
"""

from __future__ import annotations

import importlib.util
import sys
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from pathlib import Path

from domeshim.measure.apart import Program
from domeshim.measure.comparison import Comparison, Run
from domeshim.measure.difference import Difference
from domeshim.measure.sheet import write_sheet

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "docs" / "compare.md"
SCENE = ROOT / "benchmarks" / "faulty_scene.py"
BEGIN, END = "<!-- sensitivity: written by make sensitivity -->", "<!-- sensitivity: end -->"
SIZE = (512, 512)


@dataclass(frozen=True)
class Fault:
    """One way to be wrong: another setting of the dome, or another argument of the program on the dome."""

    words: str
    settings: dict[str, str] = field(default_factory=dict)
    argument: str = ""
    expected: str = "different"


NONE = Fault("none", expected="alike")
ANGLES = (
    Fault("field of view 1 degree too wide", {"fov": "181"}),
    Fault("field of view 1 degree too narrow", {"fov": "179"}),
    Fault("tilted by 1 degree", {"tilt": "1"}),
    Fault("tilted by a third of a degree", {"tilt": "0.333"}),
)
SCENES = (
    Fault("an object of 1 % of the picture is missing", argument="missing"),
    Fault("that object moved by half its own width", argument="moved"),
    Fault("red and blue swapped", argument="swapped"),
    Fault("unlit", argument="unlit"),
    Fault("without fog", argument="fogless"),
    Fault("without depth test", argument="deep"),
    Fault("without texture", argument="textureless"),
    Fault("mirrored", argument="mirrored"),
    Fault("nothing drawn", argument="nothing"),
)
LENSES = (Fault("a lens 0.5 % too long at the rim", {"lens": "polynomial:0.6302,0,0.0013"}),)
DEMOS = ("GLUT/gears.py", "NeHe/lesson5.py", "NeHe/lesson12.py", "redbook/teapots.py", "redbook/fog.py")


@dataclass(frozen=True)
class Faulty(Comparison):
    """A comparison whose dome is drawn with a fault, and told where things are as if it were sound."""

    fault: Fault = NONE

    def take(
        self,
        *,
        dome: bool,
        side: int | None = None,
        frames: tuple[int, ...] | None = None,
        plain: bool = True,
    ) -> Run:
        """Run the program, and with the fault as well where it is for the dome."""
        sound = super().take(dome=dome, side=side, frames=frames, plain=plain)
        if not dome or self.fault is NONE:
            return sound
        args = (self.fault.argument,) if self.fault.argument else self.program.args
        wrong = Comparison(replace(self.program, args=args), self.frames, self.size, self.fault.settings)
        drawn = wrong.take(dome=True, side=side, frames=frames, plain=plain).exposures
        return Run({n: replace(at, picture=drawn[n].picture) for n, at in sound.exposures.items()}, ())


def judged(program: Program, fault: Fault, pictures: Path | None) -> Difference:
    """The difference that a fault makes."""
    [result] = Faulty(program, size=SIZE, fault=fault).results()
    if pictures is not None and result.monitor is not None:
        name = f"{Path(program.prog).stem}-{fault.words.replace(' ', '-')}.png"
        write_sheet(pictures / name, result, f"{fault.words}: {result.verdict}")
    return result.difference


def programs() -> Iterator[tuple[Program, tuple[Fault, ...]]]:
    """What is judged, each with its faults."""
    yield Program(str(SCENE)), (NONE, *ANGLES, *LENSES, *SCENES)
    spec = importlib.util.find_spec("OpenGL_Demo")
    if spec is None or not spec.submodule_search_locations:
        raise SystemExit("PyOpenGL-Demo is not installed: pip install PyOpenGL-Demo")
    demos = Path(spec.submodule_search_locations[0])
    for name in DEMOS:
        yield Program(str(demos / name), folder=(demos / name).parent), (NONE, *ANGLES[:3])


def line(name: str, fault: Fault, found: Difference) -> str:
    """One row of the table."""
    moved = f"{found.moved.largest:.1f}, scale {found.moved.scale:+.2%}" if found.moved else ""
    verdict = found.verdict if found.verdict == fault.expected else f"**{found.verdict}**"
    return f"| `{name}` | {fault.words} | {verdict} | {found.wrong:.2%} | {found.mean:.2f} | {moved} |"


def main(arguments: list[str]) -> None:
    """Judge every fault, write the table, and end with status 1 where a verdict is not the expected one."""
    pictures = Path(arguments[0]) if arguments else None
    rows = [
        "| program | fault | verdict | wrong pixels | mean difference | moved, pixels |",
        "|---|---|---|---|---|---|",
    ]
    missed = 0
    for program, faults in programs():
        for fault in faults:
            found = judged(program, fault, pictures)
            rows.append(line(Path(program.prog).name, fault, found))
            print(rows[-1], flush=True)
            missed += found.verdict != fault.expected
    text = PAGE.read_text()
    before, after = text[: text.index(BEGIN)], text[text.index(END) :]
    PAGE.write_text("\n".join([before + BEGIN, "", *rows, "", after]))
    print(f"wrote {PAGE}; {missed} verdicts other than expected")
    sys.exit(1 if missed else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
