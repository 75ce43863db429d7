"""The dome's numbers under stress: how far each method draws stiff geometry from its true place."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from domeshim.draw.subdivide import subdivision_of
from domeshim.draw.submit import Submitter
from domeshim.lens.models import lens_of
from domeshim.lens.orientation import Orientation
from domeshim.measure.deviation import Deviation, Sight, deviation
from domeshim.measure.extremes import Extreme
from domeshim.measure.feedback import CatchingDriver, Caught
from domeshim.options import Options
from domeshim.record.runs import Block, Run
from domeshim.state.context import DomeContext
from domeshim.state.perspective import DepthRange, perspective
from domeshim.window.contract import SurfaceFormat, WindowEvents
from domeshim.window.frame import Frame
from domeshim.window.offscreen import OffscreenBackend

SIZES = (1024, 4096, 8192)
TOLERANCES = (2.0, 0.5, 0.1)
METHODS = ("auto", "paper", "vertex", "tessellate", "geometry", "cpu")
"""All but cubemap, which draws no geometry onto the disc and is judged by its pictures."""
SUBDIVIDING = tuple(name for name in METHODS if name not in ("paper", "vertex"))

_WINDOW = (64, 64)
_MODELVIEW, _PROJECTION = 0x1700, 0x1701
_AT = 0.5
"""All is measured at this tolerance, in frames scaled accordingly: only their ratio decides what is drawn."""


@dataclass(frozen=True)
class Row:
    """One case by one method."""

    case: Extreme
    method: str
    found: dict[float, Deviation]
    """By the disc's radius over the tolerance."""

    def pixels(self, size: int, tolerance: float) -> Deviation:
        """The largest deviations in a frame of size x size pixels."""
        edges, inside = self.found[ratio(size, tolerance)]
        return Deviation(edges * size / 2, inside * size / 2)


def ratio(size: int, tolerance: float) -> float:
    """The radius of a frame's disc over the tolerance."""
    return size / 2 / tolerance


RATIOS = tuple(sorted({ratio(size, tolerance) for size in SIZES for tolerance in TOLERANCES}))


def measure(
    cases: Sequence[Extreme], methods: Mapping[str, Sequence[float]], heard: Callable[[Row], object]
) -> tuple[list[Row], str]:
    """Every case by every method, off screen, at ratios of the disc's radius to the tolerance; and GL's name.

    heard: is told of each row. Raises ScreenError where there is no off-screen GL.
    """
    backend = OffscreenBackend()
    try:
        window = backend.open_window("stability", _WINDOW, None, SurfaceFormat(), WindowEvents())
        window.make_current()
        bench = Bench()
        rows = []
        for case in cases:
            for method, ratios in methods.items():
                row = Row(case, method, dict(bench.deviations(case, method, ratios)))
                heard(row)
                rows.append(row)
        return rows, bench.renderer
    finally:
        backend.close()


class Bench:
    """Draws cases in the current context by the dome's own pipeline, and catches what comes out."""

    def __init__(self) -> None:
        self._driver = CatchingDriver()
        self._submitter = Submitter(self._driver)
        self._contexts: dict[Options, DomeContext] = {}

    @property
    def renderer(self) -> str:
        """What GL draws with."""
        return self._driver.renderer.decode()

    def deviations(
        self, case: Extreme, method: str, ratios: Sequence[float]
    ) -> Iterator[tuple[float, Deviation]]:
        """(ratio, deviation) for each ratio of the disc's radius to the tolerance."""
        options = Options(
            enabled=True, fov=case.fov, lens=case.lens, tilt=case.tilt, method=method, tolerance=_AT
        )
        depth = DepthRange(case.near, case.far).uniform
        sight = Sight(lens_of(*case.lens, case.fov), case.fov, Orientation.of(options), depth)
        same: Deviation | None = None
        for wanted in ratios:
            if same is None or method in SUBDIVIDING:
                same = deviation(self.catch(case, options, wanted), case.edges, case.allowed, sight)
            yield wanted, same

    def catch(self, case: Extreme, options: Options, wanted: float) -> list[Caught]:
        """What the case becomes before it is rasterised; wanted: the disc's radius over the tolerance."""
        side = round(2 * _AT * wanted)
        frame = Frame((side, side), _WINDOW)
        if options not in self._contexts:
            self._contexts[options] = DomeContext(options, frame, self._driver)
        context = self._contexts[options]
        context.frame = frame
        self._look(context, case)
        positions = case.positions
        if (positions[:, 3] == 1).all():
            positions = positions[:, :3].copy()
        run = Run(positions, {}, (Block(case.mode, 0, len(positions)),))
        self._submitter.draw_as_needed(run, context, subdivision_of(run, context))
        context.undress()
        caught, self._driver.caught = self._driver.caught, []
        return caught

    def _look(self, context: DomeContext, case: Extreme) -> None:
        """Set the matrices, as gluPerspective does."""
        from OpenGL import GL  # noqa: PLC0415 - not before PYOPENGL_PLATFORM is chosen

        context.undress()
        camera = perspective(60.0, 1.0, case.near, case.far)
        assert camera is not None
        GL.glMatrixMode(_PROJECTION)
        context.matrix_mode_changed(_PROJECTION)
        context.perspective_set(camera)
        GL.glLoadMatrixd(camera.T.copy())
        GL.glMatrixMode(_MODELVIEW)
        context.matrix_mode_changed(_MODELVIEW)
        GL.glLoadIdentity()
        context.anything_changed()
