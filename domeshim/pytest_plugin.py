"""pytest's plugin: the fixture dome, which compares a program's dome picture with its monitor picture.

Light at import: every pytest of the environment loads it, also those that draw nothing.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from domeshim.measure.apart import Program
    from domeshim.measure.match import Picture

STORED = "dome_pictures"
"""The folder of stored pictures, beside the test's file, where nothing else is set."""
Size = int | tuple[int, int]


def pytest_addoption(parser: pytest.Parser) -> None:
    """The options that go with the fixture."""
    group = parser.getgroup("domeshim", "pictures on the dome")
    group.addoption(
        "--dome-update", action="store_true", help="store dome pictures instead of comparing them"
    )
    group.addoption("--dome-output", metavar="DIR", help="folder for the pictures of failures [tmp_path]")
    parser.addini("dome_pictures", f"folder of stored dome pictures [{STORED} beside the test's file]")


@pytest.fixture
def dome(request: pytest.FixtureRequest, tmp_path: Path) -> DomePictures:
    """Compares a program's pictures on the dome with those on the monitor, or with stored ones."""
    output = request.config.getoption("--dome-output")
    folder = Path(str(output)).absolute() if output else tmp_path
    pictures = request.config.getini("dome_pictures")
    stored = request.config.rootpath / str(pictures) if pictures else request.path.parent / STORED
    return DomePictures(folder, stored, bool(request.config.getoption("--dome-update")))


class DomePictures:
    """What a test asks of a program's pictures. What fails, fails the test, and leaves a picture behind.

    A program is a file's path, run in its own folder; settings are those of the DOME_* variables by their
    lower-case names, as in fov=200.
    """

    def __init__(self, folder: Path, stored: Path, update: bool) -> None:
        self.folder = folder
        """Where pictures of failures go."""
        self.stored = stored
        """Where the snapshots lie."""
        self._update = update

    def compare(
        self,
        program: str | Path,
        *args: str,
        frames: int | Sequence[int] = 1,
        size: Size = 512,
        **settings: object,
    ) -> None:
        """Fail unless the program shows on the dome what it shows on the monitor, in all these pictures.

        frames: their numbers, 1 the first; size: of the monitor's window, pixels.
        """
        __tracebackhide__ = True
        from domeshim.measure.comparison import Comparison  # noqa: PLC0415 - see the module's docstring
        from domeshim.measure.verdicts import judged  # noqa: PLC0415

        run = self._program(program, args)
        comparison = Comparison(run, _numbers(frames), _pixels(size), _texts(settings))
        failed = [
            judged(result, run, None, self.folder).text()
            for result in comparison.results()
            if result.verdict != "alike"
        ]
        if failed:
            pytest.fail("\n".join(failed), pytrace=False)

    def snapshot(
        self,
        program: str | Path,
        *args: str,
        frames: int | Sequence[int] = 1,
        size: Size = 512,
        **settings: object,
    ) -> None:
        """Fail unless the dome's pictures are those stored; --dome-update stores them.

        size: of the dome's picture, pixels.
        """
        __tracebackhide__ = True
        from domeshim.measure.baseline import Baseline  # noqa: PLC0415 - see the module's docstring
        from domeshim.measure.comparison import UNKNOWN, Compared  # noqa: PLC0415
        from domeshim.measure.sheet import compared_with  # noqa: PLC0415

        name = Path(program).stem
        baseline = Baseline(self.stored, self._update)
        failed = []
        for frame, picture in self._taken(program, args, _numbers(frames), _pixels(size), settings).items():
            result = Compared(frame, _pixels(size), UNKNOWN, dome=picture)
            found = baseline.held(name, result)
            if found is None or found.verdict == "alike":
                continue
            path = baseline.path(name, result)
            line = f"{name}, picture {frame}: {found.reason} ({path})"
            if path.exists():
                self.folder.mkdir(parents=True, exist_ok=True)
                kept = self.folder / path.name
                compared_with(Baseline.stored(path), picture, line).save(kept)
                line += f"\n  picture  {kept}\n  if it is right as it is now: pytest --dome-update"
            else:
                line = (
                    f"{name}, picture {frame}: no stored picture {path}; store it with pytest --dome-update"
                )
            failed.append(line)
        if failed:
            pytest.fail("\n".join(failed), pytrace=False)

    def picture(
        self, program: str | Path, *args: str, frame: int = 1, size: Size = 512, **settings: object
    ) -> Picture:
        """The program's picture on the dome: (height, width, 3), RGB bytes, the top row first."""
        __tracebackhide__ = True
        return self._taken(program, args, (frame,), _pixels(size), settings)[frame]

    def _taken(
        self,
        program: str | Path,
        args: tuple[str, ...],
        frames: tuple[int, ...],
        size: tuple[int, int],
        settings: dict[str, object],
    ) -> dict[int, Picture]:
        """The dome's pictures by number; fails the test where there are none."""
        __tracebackhide__ = True
        from domeshim.measure.apart import NoExposureError  # noqa: PLC0415 - as above
        from domeshim.measure.comparison import Comparison  # noqa: PLC0415 - as above

        comparison = Comparison(self._program(program, args), frames, size, _texts(settings))
        why = ""
        try:
            run = comparison.take(dome=True, plain=False)
        except NoExposureError as error:
            why = f"{Path(program).name}: {error}"
        if why:
            pytest.fail(why, pytrace=False)
        return {frame: exposure.picture for frame, exposure in run.exposures.items()}

    @staticmethod
    def _program(program: str | Path, args: tuple[str, ...]) -> Program:
        from domeshim.extras import require  # noqa: PLC0415 - see the module's docstring
        from domeshim.measure.apart import Program  # noqa: PLC0415

        require("scipy", "measure", "the fixture dome")
        path = Path(program).absolute()
        return Program(str(path), tuple(args), folder=path.parent)


def _numbers(frames: int | Sequence[int]) -> tuple[int, ...]:
    return (frames,) if isinstance(frames, int) else tuple(sorted(set(frames)))


def _pixels(size: Size) -> tuple[int, int]:
    return (size, size) if isinstance(size, int) else size


def _texts(settings: dict[str, object]) -> dict[str, str]:
    return {name: str(value) for name, value in settings.items()}
