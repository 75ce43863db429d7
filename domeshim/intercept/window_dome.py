"""All that the dome keeps for one window, and how its pictures are finished."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from typing import TYPE_CHECKING

from domeshim.draw.card import TestCard
from domeshim.draw.rim import Rim
from domeshim.draw.submit import Submitter
from domeshim.draw.target import drawing_to
from domeshim.driver import Driver
from domeshim.options import Options
from domeshim.record.lists import DisplayLists
from domeshim.state.context import DomeContext
from domeshim.window.frame import Frame

if TYPE_CHECKING:
    from domeshim.draw.arrays import ArrayDraws
    from domeshim.draw.evaluated_draws import EvaluatedDraws
    from domeshim.draw.finish import Finish
    from domeshim.draw.finishing import Finishing
    from domeshim.lens.mesh import Floats
    from domeshim.record.arrays import ArrayReader


class WindowDome:
    """All that the dome keeps for one window."""

    def __init__(
        self,
        options: Options,
        driver: Driver,
        frame: Frame,
        window: Callable[[], int],
        around: WindowDome | None = None,
    ) -> None:
        """window: as for DomeContext; around: the outermost window's, where this one lies inside another."""
        main = around.context.placer.main if around else None
        self.context: DomeContext = DomeContext(options, frame, driver, main, window)
        self.lists = DisplayLists(driver, apart=self.context.several)
        self.submitter = Submitter(driver)
        self.rim = Rim(driver)
        self.card = TestCard(driver, options)
        self._options = options
        self._finish: tuple[Finishing, Finish] | None = None

    @cached_property
    def evaluated(self) -> EvaluatedDraws:
        """Draws what GL evaluates."""
        from domeshim.draw.evaluated_draws import EvaluatedDraws  # noqa: PLC0415 - with the first of them

        return EvaluatedDraws(self.context, self.submitter, self.lists)

    @cached_property
    def arrays(self) -> ArrayReader:
        """Reads the program's vertex arrays."""
        from domeshim.record.arrays import ArrayReader  # noqa: PLC0415 - with the first draw from arrays

        return ArrayReader(self.context.driver)

    @cached_property
    def array_draws(self) -> ArrayDraws:
        """What is known of draws from them."""
        from domeshim.draw.arrays import ArrayDraws  # noqa: PLC0415 - as above

        return ArrayDraws(self.context, self.submitter, self.lists)

    def end_frame(self) -> None:
        """The picture is complete: cut it at the rim. The window must be current."""
        context = self.context
        if context.aside.passing:
            context.undress()
            return
        steady = context.placer.steady
        if steady is not None and steady.blind:
            context.say_once(
                "DOME_MAX_TURN: no gluLookAt tells where the program looks; its view turns freely"
            )
        context.settle()
        context.scene.stale.add("textures")  # the next picture may do without
        with drawing_to(context.driver, context.window()):
            self.rim.draw(context.frame, context.lens.rim)
            self.card.draw(context.frame)
            if context.shows_levels:
                from domeshim.draw.levels import draw_legend  # noqa: PLC0415 - for those who look at levels

                draw_legend(context.driver, context.frame)

    def finish(self) -> None:
        """Make of the picture in the back buffer what the projector needs; the window must be current."""
        if self.context.aside.passing or not self._options.finishes:
            return
        self.context.undress()
        wanted = self._finishing
        if self._finish is None or self._finish[0] is not wanted:
            from domeshim.draw.finish import Finish  # noqa: PLC0415 - moderngl for those alone who need it

            if self._finish is not None:
                self._finish[1].close()
            self._finish = wanted, Finish(self.context.driver, wanted, self.context.window)
        self._finish[1].draw()
        self.context.put_back = self._finish[1].put_back

    @property
    def holds_passes(self) -> bool:
        """It holds more of GL than goes with the window's context."""
        return self.context.canvas.framebuffer is not None or self._finish is not None

    def close(self) -> None:
        """Free what the passes over whole pictures hold of GL; the window must be current."""
        self.context.canvas.close()
        if self._finish is not None:
            self._finish[1].close()
            self._finish = None

    def before_finish(self, place: Floats) -> Floats:
        """Where a place (2,) of what is seen was before it was finished."""
        return self._finishing.before(place) if self._options.finishes else place

    @property
    def _finishing(self) -> Finishing:
        """What the projector wants of this window's pictures."""
        if self._finish is None or self._finish[0].frame != self.context.frame:
            from domeshim.draw.finishing import Finishing  # noqa: PLC0415 - as above

            return Finishing(self._options, self.context.frame)
        return self._finish[0]
