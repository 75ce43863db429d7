"""Bitmaps and images that are drawn flat: as large on the panel as they were in the monitor's window."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from ctypes import c_double, c_float
from functools import lru_cache, partial
from typing import TYPE_CHECKING, NamedTuple

from domeshim.draw.flat_pixels import as_texture, draw_cells, draw_over
from domeshim.draw.glyphs import Glyphs, draw_bitmaps
from domeshim.options import Options
from domeshim.record.bitmaps import Bitmap
from domeshim.shading.recipe import Scene, Texture
from domeshim.state.raster import Point
from domeshim.window.frame import Rectangle

if TYPE_CHECKING:
    from domeshim.state.context import DomeContext

_POSITION, _VALID, _COLOR, _TEXTURE_COORDINATES = 0x0B07, 0x0B08, 0x0B04, 0x0B06
_DISTANCE, _DEPTH_RANGE = 0x0B09, 0x0B70
_ZOOM_X, _ZOOM_Y = 0x0D16, 0x0D17
_MODELVIEW, _PROJECTION, _MODELVIEW_MATRIX, _PROJECTION_MATRIX = 0x1700, 0x1701, 0x0BA6, 0x0BA7
_CURRENT_POLYGON_TRANSFORM_BITS, _FRONT_AND_BACK, _FILL, _TEXTURE0 = 0x1009, 0x0408, 0x1B02, 0x84C0
_OF_POLYGONS = (0x0B44, 0x0B42, 0x8037, 0x0B41)
"""Culling, stipple, offset and smoothing of polygons: no bitmap has them."""
_SLACK = 0.01
"""Pixels by which a raster position may miss a pixel's border and still be meant to be there."""
_MOST = 4096
"""So many places are remembered."""
_WHITE = (1.0, 1.0, 1.0, 1.0)
_PICTURE = Scene(textures=(Texture(0),))


class Spot(NamedTuple):
    """The raster position in the program's window."""

    x: float
    y: float
    depth: float
    """0 to 1, before glDepthRange."""


class PanelPixels:
    """Draws at the raster position of one context on the panel."""

    def __init__(self, context: DomeContext, options: Options) -> None:
        self._context = context
        self._options = options
        self._glyphs = Glyphs(context.driver)
        self._spots: dict[object, Spot] = {}
        self._points: dict[object, list[Point | None]] = {}

    @property
    def due(self) -> bool:
        """What is drawn now belongs on the panel, and only the fixed pipeline's colours with it."""
        if not self._possible:
            return False
        placement = self._context.seen.placement
        if placement.place != "panel" or (placement.hud and self._options.hud != "panel"):
            return False
        return not self._context.scene_now().clip_planes

    @property
    def _possible(self) -> bool:
        """What is drawn now would be the dome's, and only the fixed pipeline's colours with it."""
        context = self._context
        if context.aside.bypassed or context.compiling or context.aside.passing:
            return False
        return context.own.current is None and context.own.fragments is None and not context.shows_levels

    def write(self, bitmaps: Sequence[Bitmap]) -> None:
        """Draw bitmaps one after the other, as glBitmap does: on the panel, or in the dome's own pixels."""
        if not (self.due and self._write_flat(bitmaps)):
            self._context.raster.draw(partial(draw_bitmaps, self._context.driver, bitmaps))

    def _write_flat(self, bitmaps: Sequence[Bitmap]) -> bool:
        """Draw bitmaps on the panel; False where the raster position is nowhere."""
        spot = self._spot()
        if spot is None:
            return False
        x, y = spot.x, spot.y
        placed = []
        for bitmap in bitmaps:
            if bitmap.shows:
                origin_x, origin_y = bitmap.origin
                placed.append((math.floor(x - origin_x + _SLACK), math.floor(y - origin_y + _SLACK), bitmap))
            x, y = x + bitmap.move[0], y + bitmap.move[1]
        if placed:
            scene = _flat(self._context.scene_now())
            shape = partial(self._glyphs.draw, placed)
            self._draw(shape, Spot(0.0, 0.0, spot.depth), scene, self._floats(_COLOR))
        if (x, y) != (spot.x, spot.y):
            self._move(spot._replace(x=x, y=y))
        return True

    def image(self, width: int, height: int, load: Callable[[], object]) -> bool:
        """Draw an image by the program's glPixelZoom; False where the raster position is nowhere.

        load: makes it the image of the texture that is bound.
        """
        spot = self._spot()
        if spot is None:
            return False
        context = self._context
        zoom_x, zoom_y = (context.driver.doubles(name, 1)[0] for name in (_ZOOM_X, _ZOOM_Y))
        scene = _textured(context.scene_now())
        shape = partial(draw_cells, context.driver, width * zoom_x, height * zoom_y)
        with as_texture(context.driver, context.scene.texture_units, load):
            self._draw(shape, spot, scene, _WHITE)
        return True

    def picture(self, area: Rectangle, load: Callable[[], object]) -> bool:
        """Draw an image over an area of the program's window, whatever goes there now; False if it cannot.

        area: a negative width or height flips it; load: as for image.
        """
        if not self._possible or self._context.scene_now().clip_planes:
            return False
        left, bottom, width, height = area
        shape = partial(draw_over, self._context.driver, width, height)
        with as_texture(self._context.driver, self._context.scene.texture_units, load):
            self._draw(shape, Spot(left, bottom, 0.0), _PICTURE, _WHITE)
        return True

    def _draw(self, shape: Callable[[], object], spot: Spot, scene: Scene, colour: tuple[float, ...]) -> None:
        """Draw a shape whose unit is a pixel of the program's window, its origin at a spot there."""
        gl = self._context.driver
        texture = self._floats(_TEXTURE_COORDINATES) if scene.textures else None
        distance = gl.doubles(_DISTANCE, 1)[0] if scene.fog else None

        def call(viewport: Rectangle) -> None:
            gl.glPushAttrib(_CURRENT_POLYGON_TRANSFORM_BITS)
            gl.glPolygonMode(_FRONT_AND_BACK, _FILL)
            for capability in _OF_POLYGONS:
                gl.glDisable(capability)
            gl.glColor4f(*colour)
            if texture is not None:
                gl.glMultiTexCoord4f(_TEXTURE0, *texture)
            if distance is not None:
                gl.glFogCoordf(distance)
            self._in_window(shape, spot, viewport)
            gl.glPopAttrib()

        self._context.draw_flat(call, scene)

    def _in_window(self, shape: Callable[[], object], spot: Spot, viewport: Rectangle) -> None:
        """Draw a shape under matrices by which its coordinates are pixels of the program's window."""
        gl = self._context.driver
        left, bottom, width, height = viewport
        modelview, projection = gl.doubles(_MODELVIEW_MATRIX, 16), gl.doubles(_PROJECTION_MATRIX, 16)
        x, y, z = 2 * (spot.x - left) / width - 1, 2 * (spot.y - bottom) / height - 1, 2 * spot.depth - 1
        to_clip = (2 / width, 0, 0, 0, 0, 2 / height, 0, 0, 0, 0, 1, 0, x, y, z, 1)
        gl.glMatrixMode(_PROJECTION)
        gl.glLoadIdentity()
        gl.glMatrixMode(_MODELVIEW)
        gl.glLoadMatrixd((c_double * 16)(*to_clip))
        shape()
        gl.glLoadMatrixd((c_double * 16)(*modelview))
        gl.glMatrixMode(_PROJECTION)
        gl.glLoadMatrixd((c_double * 16)(*projection))

    def _spot(self) -> Spot | None:
        context, gl = self._context, self._context.driver
        context.raster.begin()
        if not gl.integer(_VALID):
            return None
        key = (gl.doubles(_POSITION, 4), self._sight)
        known = self._spots.get(key)
        if known is None:
            raster = context.pixels.raster
            if raster is None:
                return None
            x, y, z, _ = raster.position
            near, far = gl.doubles(_DEPTH_RANGE, 2)
            known = Spot(x, y, (z - near) / (far - near) if near != far else 0.0)
            self._remember(key, known)
        return known

    def _move(self, spot: Spot) -> None:
        """Put GL's raster position where the panel has a place of the window, and remember what it means."""
        context = self._context
        near, far = context.driver.doubles(_DEPTH_RANGE, 2)
        key = (spot, near, far, self._sight)
        points = self._points.get(key)
        if points is None:
            found = context.pixels.positions(*spot)
            points = [p and (p[0], p[1], near + (far - near) * p[2]) for p in found]
            if len(self._points) >= _MOST:
                self._points.clear()
            self._points[key] = points
        context.raster.move(points)
        self._remember((context.driver.doubles(_POSITION, 4), self._sight), spot)

    def _remember(self, key: object, spot: Spot) -> None:
        if len(self._spots) >= _MOST:
            self._spots.clear()
        self._spots[key] = spot

    @property
    def _sight(self) -> object:
        """All that decides where the program's window is seen."""
        frame, view = self._context.frame, self._context.placer.main.view
        return (frame, view and (view.camera.tobytes(), view.turn.tobytes(), view.viewport))

    def _floats(self, name: int) -> tuple[float, ...]:
        values = (c_float * 4)()
        self._context.driver.glGetFloatv(name, values)
        return tuple(values)


@lru_cache(maxsize=256)
def _flat(scene: Scene) -> Scene:
    """What is left of a scene for pixels that have their colour already."""
    return Scene(
        textures=tuple(Texture(texture.unit) for texture in scene.textures),
        fog="attribute" if scene.fog else None,
        secondary_color=scene.secondary_color,
    )


@lru_cache(maxsize=256)
def _textured(scene: Scene) -> Scene:
    """The same where their colour is a texture's."""
    return Scene(textures=(Texture(0),), fog="attribute" if scene.fog else None)
