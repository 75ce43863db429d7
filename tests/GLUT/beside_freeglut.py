"""Run under an X server: draw with freeglut and with domeshim in one window; print how they differ."""

from __future__ import annotations

import ctypes
import json
import sys
from collections.abc import Callable
from typing import Any

import numpy as np
from OpenGL import GL, GLU
from OpenGL import GLUT as stock  # noqa: N811 - the other GLUT is domeshim's

from domeshim.GLUT import fonts, solids
from domeshim.GLUT.typefaces.load import glut_library

SIZE = 400
CASES: dict[str, list[tuple[Any, ...]]] = {
    "Sphere": [(1.0, 20, 20), (1.5, 5, 3), (1.0, 1, 2), (1.0, 0, 5), (1.0, 5, 1), (-1.0, 9, 9)],
    "Cone": [(1.0, 2.0, 20, 10), (1.2, 1.0, 5, 1), (1.0, 1.0, 1, 1), (1.0, 1.0, 0, 1), (1.0, 1.0, 4, 0)],
    "Cylinder": [(1.0, 1.5, 20, 5), (1.0, 1.0, 3, 1), (1.0, 1.0, 0, 1), (1.0, 1.0, 4, 0)],
    "Torus": [(0.4, 1.0, 20, 30), (0.5, 1.0, 3, 3), (0.5, 1.0, 2, 2), (0.5, 1.0, 1, 5), (0.5, 1.0, 5, 1)],
    "Cube": [(1.0,), (1.5,)],
    "Tetrahedron": [()],
    "Octahedron": [()],
    "Dodecahedron": [()],
    "Icosahedron": [()],
    "RhombicDodecahedron": [()],
    "SierpinskiSponge": [(0, (0, 0, 0), 1.5), (3, (0.1, 0.2, 0.3), 1.5), (-1, (0, 0, 0), 1.0)],
    "Teapot": [(1.0,), (1.4,), (-1.0,)],
    "Teacup": [(1.0,), (2.5,)],
    "Teaspoon": [(1.0,), (3.0,)],
}
SWITCHES: dict[str, tuple[int, ...]] = {
    "lit": (GL.GL_LIGHTING, GL.GL_LIGHT0, GL.GL_DEPTH_TEST),
    "textured": (GL.GL_LIGHTING, GL.GL_LIGHT0, GL.GL_DEPTH_TEST, GL.GL_TEXTURE_2D),
    "culled": (GL.GL_LIGHTING, GL.GL_LIGHT0, GL.GL_CULL_FACE),
    "flat": (GL.GL_LIGHTING, GL.GL_LIGHT0, GL.GL_DEPTH_TEST),
    "blended": (GL.GL_BLEND,),
    "plain": (GL.GL_DEPTH_TEST,),
    "stippled": (GL.GL_LINE_STIPPLE,),
}
MODES = {"Solid": ("lit", "textured", "culled", "flat", "blended"), "Wire": ("lit", "plain", "stippled")}
TEXT = bytes(range(32, 80)) + b"\n" + bytes(range(80, 130)) + b"\nHello, World gjpqy \xe9\xdf\xff"


def open_window() -> None:
    stock.glutInit()
    stock.glutInitDisplayMode(stock.GLUT_RGB | stock.GLUT_DEPTH | stock.GLUT_DOUBLE)
    stock.glutInitWindowSize(SIZE, SIZE)
    stock.glutCreateWindow(b"beside freeglut")
    speckles = np.random.RandomState(0).randint(0, 255, (16, 16, 3)).astype(np.uint8)
    GL.glTexImage2D(GL.GL_TEXTURE_2D, 0, GL.GL_RGB, 16, 16, 0, GL.GL_RGB, GL.GL_UNSIGNED_BYTE, speckles)
    GL.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_MIN_FILTER, GL.GL_LINEAR)


def scene(mode: str) -> None:
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glLoadIdentity()
    GLU.gluPerspective(45, 1, 0.5, 20)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glLoadIdentity()
    GL.glLightfv(GL.GL_LIGHT0, GL.GL_POSITION, (3, 4, 5, 0))
    GL.glTranslatef(0, 0, -5)
    GL.glRotatef(35, 1, 0, 0)
    GL.glRotatef(25, 0, 1, 0)
    for switch in {switch for switches in SWITCHES.values() for switch in switches}:
        GL.glDisable(switch)
    for switch in SWITCHES[mode]:
        GL.glEnable(switch)
    GL.glShadeModel(GL.GL_FLAT if mode == "flat" else GL.GL_SMOOTH)
    GL.glBlendFunc(GL.GL_SRC_ALPHA, GL.GL_ONE_MINUS_SRC_ALPHA)
    GL.glLineStipple(2, 0x1F1F)
    GL.glColor4f(1, 0.8, 0.6, 0.3)
    GL.glNormal3f(0, 0, 1)


def panel() -> None:
    scene("plain")
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glLoadIdentity()
    GL.glOrtho(0, SIZE, 0, SIZE, -1, 1)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glLoadIdentity()


def picture(*steps: Callable[[], object]) -> np.ndarray:
    GL.glClearColor(0.1, 0.1, 0.2, 1)
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
    for step in steps:
        step()
    pixels = GL.glReadPixels(0, 0, SIZE, SIZE, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)
    return np.frombuffer(pixels, np.uint8).reshape(SIZE, SIZE, 3).astype(int)


def difference(theirs: np.ndarray, ours: np.ndarray) -> dict[str, int]:
    """Pixels drawn by freeglut; pixels that differ at all; pixels that differ by more than 8 of 255."""
    apart = abs(theirs - ours).max(axis=-1)
    drawn = (theirs != (26, 26, 51)).any(axis=-1)
    return {"drawn": int(drawn.sum()), "any": int((apart > 0).sum()), "plain": int((apart > 8).sum())}


def freeglut(name: str) -> Callable[..., Any]:
    """A function of freeglut, also one that PyOpenGL leaves out (all of those take one double)."""
    found = getattr(stock, name, None)
    if found is None:
        found = getattr(glut_library(), name)
        found.argtypes = [ctypes.c_double]
    return found


def compare_solids() -> dict[str, Any]:
    results = {}
    for shape, parameters in CASES.items():
        for kind, modes in MODES.items():
            name = f"glut{kind}{shape}"
            for given in parameters:
                theirs = [np.array(v, float) if isinstance(v, tuple) else v for v in given]
                for mode in modes:
                    results[f"{name}{given} {mode}"] = difference(
                        picture(lambda m=mode: scene(m), lambda n=name, a=theirs: freeglut(n)(*a)),
                        picture(lambda m=mode: scene(m), lambda n=name, a=given: getattr(solids, n)(*a)),
                    )
    return {"pictures": results, "error": int(GL.glGetError())}


def compare_fonts() -> dict[str, Any]:
    return {"source": fonts.glyph_source(), "fonts": {str(font): compare_font(font) for font in fonts.FONTS}}


def compare_font(font: fonts.Font) -> dict[str, Any]:
    kind, pointer = font.kind.title(), getattr(stock, str(font))
    library = glut_library()
    lengths = {"theirs": getattr(library, f"glut{kind}Length")(pointer, TEXT)}
    lengths |= {"ours": getattr(fonts, f"glut{kind}Length")(font, TEXT)}

    def begin() -> None:
        panel()
        if kind == "Bitmap":
            GL.glRasterPos2f(3, 360)
        else:
            GL.glTranslatef(3, 300, 0)
            GL.glScalef(0.1, 0.1, 1)

    def letters(draw: Callable[[object, int], None], drawn: object) -> None:
        for code in [*b"Ab g\nq\xe9", 0, 128, 300]:
            draw(drawn, code)

    def ends() -> list[float]:
        matrix, raster = GL.glGetFloatv(GL.GL_MODELVIEW_MATRIX), GL.glGetFloatv(GL.GL_CURRENT_RASTER_POSITION)
        return [*matrix.ravel().tolist(), *raster.tolist()]

    pictures = {}
    string, character = f"glut{kind}String", f"glut{kind}Character"
    theirs, their_end = picture(begin, lambda: getattr(stock, string)(pointer, TEXT)), ends()
    ours, our_end = picture(begin, lambda: getattr(fonts, string)(font, TEXT)), ends()
    pictures["string"] = difference(theirs, ours)
    theirs = picture(begin, lambda: letters(getattr(stock, character), pointer))
    ours = picture(begin, lambda: letters(getattr(fonts, character), pointer))
    pictures["characters"] = difference(theirs, ours)
    return {
        "pictures": pictures,
        "moved": float(np.abs(np.subtract(their_end, our_end)).max()),
        "lengths": lengths,
        "heights": [float(getattr(m, f"glut{kind}Height")(f)) for m, f in ((stock, pointer), (fonts, font))],
        "widths": [
            [float(getattr(m, f"glut{kind}Width")(f, code)) for code in range(-1, 258)]
            for m, f in ((stock, pointer), (fonts, font))
        ],
        "error": int(GL.glGetError()),
    }


if __name__ == "__main__":
    open_window()
    print(json.dumps({"solids": compare_solids, "fonts": compare_fonts}[sys.argv[1]]()))
