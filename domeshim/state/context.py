"""One GL context on the dome: before a draw it puts the dome's program on, before a question takes it off.

Between the two the program's own state stands in GL untouched, so that whatever it asks is answered as on
the monitor (DESIGN 2.1). The dome's own state is on only while draws follow each other.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any

from domeshim.draw.canvas import Canvas, canvas_of
from domeshim.driver import Driver
from domeshim.lens.chosen import lens_chosen
from domeshim.lens.landing import Lens
from domeshim.lens.orientation import Orientation
from domeshim.options import Options
from domeshim.shading.program import Program
from domeshim.shading.recipe import Patch, Recipe, Scene
from domeshim.state.aside import Aside
from domeshim.state.binding import Binding
from domeshim.state.dresser import Dresser
from domeshim.state.own_programs import OwnPrograms
from domeshim.state.perspective import Matrix
from domeshim.state.placement import MainView, Placement, Placer
from domeshim.state.raster import RasterPoints
from domeshim.state.scene import GROUPS, SceneState
from domeshim.state.subdividing import Subdividing
from domeshim.state.views import View
from domeshim.state.whereabouts import MODELVIEW, PROJECTION, Seen, Whereabouts
from domeshim.state.window_pixels import WindowPixels
from domeshim.window.frame import Frame, Rectangle

if TYPE_CHECKING:
    from domeshim.state.panel_pixels import PanelPixels

_TEXTURE, _PATCH_VERTICES = 0x1702, 0x8E72
CURRENT_AND_LIGHTING_BITS = 0x0041
"""GL's attribute groups that a draw may change: the current colour and its like, and what follows it."""
_CURRENT_COLOR = 0x0B00


class DomeContext:
    """The dome's side of one GL context."""

    def __init__(
        self,
        options: Options,
        frame: Frame,
        driver: Driver,
        main: MainView | None = None,
        window: Callable[[], int] = lambda: 0,
    ) -> None:
        """main: that of the window around this one, if there is one.

        window: asks for the number of the window's framebuffer.
        """
        self.driver = driver
        self.window = window
        """Asks for the number of the window's framebuffer, which a toolkit may change."""
        self._frame = frame
        self.lens: Lens = lens_chosen(options)
        self.orientation = Orientation.of(options)
        self.placer = Placer(options, main)
        self.scene = SceneState(driver)
        self.own = OwnPrograms(driver, options, self.lens, self.orientation, frame)
        self.compiling = False
        """A display list is being compiled: nothing of ours may get into it."""
        self._options = options
        self.shows_levels = options.shows_levels
        """Draws are coloured by how finely they are subdivided."""
        self.binding = Binding(self)
        self.pixels = WindowPixels(self, options)
        self.subdividing = Subdividing(self, options)
        self.aside = Aside(driver, window, self.undress)
        """Whether draws are none of the dome's."""
        self._said: set[str] = set()
        self._where = Whereabouts(driver, self.placer, self.own)
        self._at_raster = False
        self._flat: Scene | None = None
        """What the last draw onto the panel, in pixels of the program's window, went through."""
        self._dresser = Dresser(self, options)
        self.worn = self._dresser.worn
        """What is on in GL now, over the program's own state."""
        self.canvas = self._canvas()
        self.raster = RasterPoints(self)
        self._patch: Patch | None = None
        self.put_back: Callable[[], object] | None = None
        """Puts the last picture back into the window, where the projector's pass has gone over it."""

    @property
    def programs(self) -> dict[Recipe, Program]:
        """The vertex programs made for this context, by what they are for."""
        stage = self.own.fragments
        return self._dresser.wardrobe.programs | (stage.programs if stage is not None else {})

    @cached_property
    def panel(self) -> PanelPixels:
        """Draws bitmaps and images flat onto the panel."""
        from domeshim.state.panel_pixels import PanelPixels  # noqa: PLC0415 - only a program that has any pays

        return PanelPixels(self, self._options)

    # What a call changed.

    def viewport_changed(self) -> None:
        """The next draw asks for the viewport again."""
        self._where.changed = True

    def matrix_mode_changed(self, mode: int) -> None:
        """Calls on the matrix stacks go to this one from now on."""
        left, self._where.matrix_mode = self._where.matrix_mode, mode
        if PROJECTION in (left, mode):
            self._where.changed = True
        if _TEXTURE in (left, mode):
            self.scene.stale.add("textures")

    def anything_changed(self) -> None:
        """A list or an attribute stack may have changed any state."""
        self.scene.stale |= GROUPS
        self._where.ask_again()
        self.own.uniforms_changed()

    def perspective_set(self, p: Matrix | None) -> None:
        """The program is about to multiply or load this perspective onto the current stack."""
        mode = self._where.matrix_mode
        if p is not None and mode in (PROJECTION, MODELVIEW):
            self.placer.perspective_set(p, on_modelview=mode == MODELVIEW)
            self._where.changed = True

    @property
    def on_projection(self) -> bool:
        """The current matrix stack is PROJECTION."""
        return self._where.matrix_mode == PROJECTION

    @property
    def bends(self) -> bool:
        """The next draw goes through a vertex program of the dome's."""
        self.dress()
        return self.worn.dressing is not None and self.worn.dressing.program != 0

    def hides(self, placement: Placement) -> bool:
        """The user wants nothing of what is drawn there."""
        return self._dresser.wardrobe.hides(placement)

    def settle(self, *, deep: bool = False) -> None:
        """Let the window show what was drawn so far, say to be read; deep: its depths as well."""
        self.undress()
        if not self.compiling:
            self.go_on()
            self.canvas.settle(deep=deep)

    def go_on(self) -> None:
        """The last picture is drawn on or read: let it be as it was before the projector's pass over it."""
        if self.put_back is not None:
            put_back, self.put_back = self.put_back, None
            put_back()

    def framebuffer_bound(self) -> None:
        """The program may have bound a framebuffer of its own, or the window again."""
        self.aside.framebuffer_bound()
        self._where.changed = True

    def say_once(self, text: str) -> None:
        """Tell the user on stderr what cannot be done exactly, once."""
        if text not in self._said:
            self._said.add(text)
            print(f"domeshim: {text}", file=sys.stderr)

    # Around the draws.

    def dress(self, patch: Patch | None = None, *, raster: bool = False) -> None:
        """Make the next draws land on the dome; call before each.

        patch: what the draw hands over to be subdivided, if it does; raster: what follows sets the raster
        position, or draws there.
        """
        if self.compiling:
            return
        if self.aside.reasons:
            self.own.leave_straight()
            if self.aside.straight_into_window:
                self.canvas.settle(deep=True, straight=True)
            return
        if self.aside.passing:
            _ = self.seen  # later pictures may go by the perspectives of this one
            return
        changed = patch != self._patch or raster != self._at_raster or self._flat is not None
        if changed or self.worn.dressing is None or self._stale:
            self._uncover()
            self.go_on()
            self._patch, self._at_raster, self._flat = patch, raster, None
            self._dresser.put_on(*self._look(), patch, raster=raster)
            if patch is not None and patch.method == "tessellate":
                self.driver.glPatchParameteri(_PATCH_VERTICES, patch.corners)

    def draw(self, call: Callable[[], object], patch: Patch | None = None) -> Any:
        """Make a draw, once in each view, and return what the call returns; patch: as for dress.

        What it leaves in GL beside pixels (the current colour, say) is as after one draw.
        """
        self.dress(patch)
        views = self.views_now
        for view in views[:-1]:
            self.worn.show(view)
            self.driver.glPushAttrib(CURRENT_AND_LIGHTING_BITS)
            call()
            self.driver.integers(_CURRENT_COLOR, 4)  # Mesa hands colours on when it is asked for them
            self.driver.glPopAttrib()
        if views:
            self.worn.show(views[-1])
        return call()

    def draw_flat(self, call: Callable[[Rectangle], object], scene: Scene) -> None:
        """Make a draw flat onto the panel, in a viewport that call is told: the window, and what is beyond.

        scene: what the fixed pipeline does for it; the same object for the same.
        """
        if self._flat is not scene or self.worn.dressing is None or self._stale:
            self._uncover()
            self.go_on()
            self._patch, self._at_raster, self._flat = None, False, scene
            seen, _ = self._look()
            self._dresser.put_on(self.pixels.flat(seen)[0], scene, None, raster=False)
        _, viewport = self.pixels.flat(self.seen)
        for view in self.views_now or (None,):
            if view is not None:
                self.worn.show(view)
            call(viewport)

    @property
    def several(self) -> bool:
        """Draws are made more than once, in a view each."""
        return len(self.canvas.views) > 1

    @property
    def views_now(self) -> tuple[View, ...]:
        """The views of the next draw where there are several."""
        dressing = self.worn.dressing
        return () if dressing is None or self.compiling or len(dressing.views) == 1 else dressing.views

    def draw_list(self, name: int, patch: Patch | None = None) -> None:
        """Draw one of GL's own lists; patch: as for dress."""
        if self.several:
            self.draw(partial(self.driver.glCallList, name), patch)
            return
        self.dress(patch)  # the same with fewer calls: programs call thousands of lists a picture
        self.driver.glCallList(name)

    @property
    def frame(self) -> Frame:
        """The real picture, and the window that the program believes in."""
        return self._frame

    @frame.setter
    def frame(self, frame: Frame) -> None:
        if frame != self._frame:
            self.put_back = None
            self.canvas.close()
            self._frame = frame
            self.canvas = self._canvas()
        self._where.changed = True

    def _canvas(self) -> Canvas:
        return canvas_of(
            self.driver, self._options, self._frame, self.lens, self.orientation, self.say_once, self.window
        )

    def undress(self) -> None:
        """Give GL back to the program just as it left it."""
        if not self.compiling:
            self._dresser.take_off()

    def _uncover(self) -> None:
        """Undress if GL is about to be asked for what the dome changes."""
        if self._where.stale or "rest" in self.scene.stale:
            self.undress()

    @property
    def _stale(self) -> bool:
        where = self._where
        return bool(
            where.changed or self.scene.stale or where.matrix_mode != MODELVIEW or self.placer.on_modelview
        )

    def _look(self) -> tuple[Seen, Scene]:
        if self._where.matrix_mode == _TEXTURE:
            self.scene.stale.add("textures")
        return self.seen, self.scene.scene()

    def scene_now(self) -> Scene:
        """What the program has enabled, for a question before a draw."""
        if self.scene.stale:
            self.undress()  # GL is asked for it, and the draw shall not go by what is worn
        return self.scene.scene()

    @property
    def seen(self) -> Seen:
        """Where what is drawn now belongs; asked of GL again only where it may have changed."""
        known = self._where.known
        if known is None or self._where.stale:
            self.undress()
            known = self._where.ask(self._frame)
        return known
