"""The views that a picture is made of, and what is on in GL while a draw is made in each of them.

A picture may show the scene more than once: an eye's disc each, a cube face each. The program draws once;
each of its draws is made once for every view.
"""

from __future__ import annotations

from typing import NamedTuple

from domeshim.draw.target import drawn_to
from domeshim.driver import Driver
from domeshim.shading.program import Uniforms
from domeshim.state.clip_planes import ClipPlanes, Equation
from domeshim.window.frame import Rectangle

_SCISSOR_TEST, _SCISSOR_BOX, _DRAW_FRAMEBUFFER = 0x0C11, 0x0C10, 0x8CA9
_DRAW_BUFFER = 0x0C01


class View(NamedTuple):
    """A rectangle of a framebuffer, and where the viewer looks or stands who sees the scene in it."""

    viewport: Rectangle
    scissor: Rectangle | None = None
    """What of it may be drawn to; None: all."""
    uniforms: tuple[tuple[str, tuple[float, ...]], ...] = ()
    """What the dome's programs are told of the viewer."""
    buffer: int | None = None
    """Which of the window's colour buffers it is in; None: the program's own choice."""


class Dressing(NamedTuple):
    """All that is on while the dome draws, and off again before the program could notice."""

    program: int
    """0: the program's own."""
    enables: tuple[int, ...]
    views: tuple[View, ...]
    uniforms: Uniforms | None = None
    """Of the program that draws; None where none of the dome's numbers reach it."""
    framebuffer: int | None = None
    """None: the program's own choice."""
    planes: tuple[tuple[int, Equation], ...] = ()
    """What stands in GL's clip planes, by number, instead of the program's."""


class Worn:
    """What the dome has on in one GL context, over the program's own state."""

    def __init__(self, driver: Driver) -> None:
        self._driver = driver
        self._own = View((0, 0, 0, 0))
        self._box: Rectangle | None = None
        """The program's scissor box, where it is switched off and was changed all the same."""
        self._buffer: int | None = None
        """The program's draw buffer, where another was chosen."""
        self._bound = 0
        """The program's framebuffer, where another was chosen."""
        self._view = self._own
        self.dressing: Dressing | None = None
        self.clip_planes = ClipPlanes(driver)

    def put_on(self, new: Dressing, own: View, program: int) -> None:
        """Put on what is not on already, take off what is too much, and show the first view.

        own: the program's own viewport and scissor; program: bound where the dome's is not.
        """
        gl, old = self._driver, self.dressing
        if old is None:
            old = Dressing(0, (), ())
            self._own = self._view = own
        self.dressing = new
        if new.enables != old.enables:
            for capability in old.enables:
                if capability not in new.enables:
                    gl.glDisable(capability)
            for capability in new.enables:
                if capability not in old.enables:
                    gl.glEnable(capability)
        if new.program != old.program:
            gl.glUseProgram(new.program or program)
        if new.planes != old.planes:
            self.clip_planes.take(dict(new.planes))
        if new.framebuffer != old.framebuffer:
            if old.framebuffer is None:
                self._bound = drawn_to(gl)
            bound = self._bound if new.framebuffer is None else new.framebuffer
            gl.glBindFramebuffer(_DRAW_FRAMEBUFFER, bound)
        self.show(new.views[0])

    def show(self, view: View) -> None:
        """Let what is drawn next go to this view."""
        assert self.dressing is not None
        self._look_at(view)
        uniforms = self.dressing.uniforms
        if uniforms is not None:
            for name, values in view.uniforms:
                uniforms.set(name, values)

    def take_off(self, program: int) -> None:
        """Leave GL as the program had it; program: as for put_on."""
        gl, old = self._driver, self.dressing
        if old is None:
            return
        self.dressing = None
        for capability in old.enables:
            gl.glDisable(capability)
        self._look_at(self._own)
        if self._box is not None:
            gl.glScissor(*self._box)
            self._box = None
        if self._buffer is not None:
            gl.glDrawBuffer(self._buffer)
            self._buffer = None
        if old.planes:
            self.clip_planes.give_back()
        if old.framebuffer is not None:
            gl.glBindFramebuffer(_DRAW_FRAMEBUFFER, self._bound)
        if old.program:
            gl.glUseProgram(program)

    def _look_at(self, view: View) -> None:
        gl, old = self._driver, self._view
        if view is old:
            return
        self._view = view
        if view.viewport != old.viewport:
            gl.glViewport(*view.viewport)
        if view.buffer is not None and view.buffer != old.buffer:
            if self._buffer is None:
                self._buffer = gl.integer(_DRAW_BUFFER)
            gl.glDrawBuffer(view.buffer)
        if view.scissor == old.scissor:
            return
        if view.scissor is None:
            gl.glDisable(_SCISSOR_TEST)
            return
        if self._own.scissor is None and self._box is None:
            x, y, w, h = gl.integers(_SCISSOR_BOX, 4)
            self._box = x, y, w, h
        gl.glScissor(*view.scissor)
        if old.scissor is None:
            gl.glEnable(_SCISSOR_TEST)
