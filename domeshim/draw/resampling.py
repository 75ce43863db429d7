"""Cube faces become the dome's picture: moderngl, in the window's own context, draws the disc."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import moderngl
import numpy as np

from domeshim.draw.attached import attached
from domeshim.draw.over import way_cleared
from domeshim.draw.transfer import plain_transfer
from domeshim.driver import Driver
from domeshim.lens.orientation import Orientation
from domeshim.lens.radial import RadialLens
from domeshim.shading.snippets import snippet

if TYPE_CHECKING:
    from domeshim.draw.atlas import Atlas
    from domeshim.state.perspective import DepthTerms
    from domeshim.state.views import View
    from domeshim.window.frame import Rectangle

_VERSION = "#version 330\n"
_STEPS = 4096
"""Of the angles by radius: between two, no lens's curve is off by a hundredth of a pixel."""
_MOST = 6
_DEPTH_TEST, _ALWAYS, _DEPTH_RANGE = 0x0B71, 0x0207, 0x0B70


class Resampling:
    """Draws one window's disc from its faces; the caller restores what is bound."""

    def __init__(
        self,
        driver: Driver,
        atlas: Atlas,
        views: tuple[View, ...],
        lens: RadialLens,
        orientation: Orientation,
    ) -> None:
        self._driver = driver
        self._rim = lens.rim
        self._context = attached(driver)
        seen_along = "aim/seen_seated" if orientation.off_centre else "aim/seen_centred"
        vertex = _VERSION + snippet("cube/window.vert")
        fragment = _VERSION + snippet(seen_along) + snippet("cube/window.frag")
        program: Any = self._context.program(vertex_shader=vertex, fragment_shader=fragment)
        self._program = program
        self._triangle = self._context.vertex_array(self._program, [])
        with plain_transfer(driver):
            angles = self._context.texture((_STEPS, 1), 1, angle_table(lens).tobytes(), dtype="f4")
        held: list[Any] = [
            self._context.external_texture(t.value, atlas.size, 4, 0, "f1") for t in atlas.textures
        ]
        self._textures = (*held, angles)
        for unit, sampler in enumerate(("faces", "depths", "angles")):
            program[sampler].value = unit
        for name, values in orientation.uniforms if orientation.off_centre else ():
            if name in program:
                program[name].value = values
        self._place(views, atlas.size)

    def _place(self, views: tuple[View, ...], size: tuple[int, int]) -> None:
        """Tell where each face lies in the atlas, and its axes."""
        places, axes = np.zeros((_MOST, 4), np.float32), np.zeros((_MOST, 3, 3), np.float32)
        for i, view in enumerate(views):
            x, y, w, h = view.viewport
            half = w / 2 / size[0], h / 2 / size[1]
            places[i] = x / size[0] + half[0], y / size[1] + half[1], *half
            axes[i] = np.reshape(dict(view.uniforms)["domeFace"], (4, 4))[:3, :3]
        self._program["places"].write(places.tobytes())
        self._program["axes"].write(axes.tobytes())
        self._program["count"].value = len(views)

    def draw(self, square: Rectangle, depths: tuple[DepthTerms, DepthTerms] | None) -> None:
        """Draw the disc into the framebuffer that is bound for drawing.

        square: the disc's, pixels; depths: what depth means on the faces, and on the disc; None:
        colours alone.
        """
        gl, program = self._driver, self._program
        x, y, side, _ = square
        program["disc"].value = x + side / 2, y + side / 2, side / 2, self._rim * side / 2
        program["deep"].value = depths is not None
        program["planar"].value, program["radial"].value = depths or ((0.0, 0.0), (0.0, 0.0))
        program["range"].value = gl.doubles(_DEPTH_RANGE, 2)
        with way_cleared(gl):
            gl.glColorMask(1, 1, 1, 1)
            gl.glViewport(*square)
            if depths is not None:
                gl.glEnable(_DEPTH_TEST)
                gl.glDepthFunc(_ALWAYS)
                gl.glDepthMask(1)
                gl.glDepthRange(0.0, 1.0)
            for unit, texture in enumerate(self._textures):
                texture.use(unit)
            self._triangle.render(moderngl.TRIANGLES, vertices=3)

    def delete(self) -> None:
        """Free what it holds of GL; the atlas's textures are the atlas's."""
        for held in (self._triangle, self._program, self._textures[-1], self._context):
            held.release()


def angle_table(lens: RadialLens, steps: int = _STEPS) -> np.ndarray[Any, np.dtype[np.float32]]:
    """(steps,): the lens's angle, radians, at even steps of the radius from 0 to the rim."""
    return lens.angle(np.linspace(0.0, lens.rim * (1 - 1e-12), steps)).astype(np.float32)
