"""The fisheye's formula in single precision: three ways to write it, on the GPU, against double precision."""

from __future__ import annotations

from ctypes import c_char_p, c_int, c_void_p
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from domeshim.errors import ShaderError
from domeshim.measure.feedback import CatchingDriver
from domeshim.shading.snippets import snippet
from domeshim.window.contract import SurfaceFormat, WindowEvents
from domeshim.window.offscreen import OffscreenBackend

_VERTEX_SHADER, _COMPILE_STATUS, _POINTS, _FLOAT, _VERTEX_ARRAY = 0x8B31, 0x8B81, 0, 0x1406, 0x8074
_NEAREST, _COUNT = 1e-8, 40_000
_LENS = "float lensRadius(float phi) { return phi / 1.5707963267948966; }\n"

FORMULAS = {
    "acos(-z / r), then cos and sin of atan(y, x)": """
vec4 bent(vec4 p) {
    float phi = acos(-p.z / length(p.xyz)), theta = atan(p.y, p.x);
    return vec4(lensRadius(phi) * vec2(cos(theta), sin(theta)), 0.0, 1.0);
}
""",
    "acos(-z / r), then x and y over their length": """
vec4 bent(vec4 p) {
    float rxy = length(p.xy);
    return vec4(rxy > 0.0 ? p.xy * (lensRadius(acos(-p.z / length(p.xyz))) / rxy) : vec2(0.0), 0.0, 1.0);
}
""",
    "asin(rxy / r), then x and y over their length": """
vec4 bent(vec4 p) {
    float rxy = length(p.xy), phi = asin(rxy / length(p.xyz));
    phi = p.z > 0.0 ? 3.14159265358979 - phi : phi;
    return vec4(rxy > 0.0 ? p.xy * (lensRadius(phi) / rxy) : vec2(0.0), 0.0, 1.0);
}
""",
    "method paper: atan(rxy, -z)": snippet("bend/radial") + snippet("bend/paper"),
    "ours: atan(rxy, -z), divided by the largest first": snippet("bend/radial") + snippet("bend/vertex"),
}
"""GLSL for a point's place on the disc of an equidistant lens of 180 degrees, by what it does."""

DISTANCES = (1.0, 1e-20, 1e20)
"""From the eye, at which each is tried."""


@dataclass(frozen=True)
class FormulaError:
    """The worst of one formula at one distance, over phi from 1e-8 to pi."""

    formula: str
    distance: float
    radii: float
    """The largest error on the disc of 180 degrees, in its radii; infinite where the result is no number."""
    phi: float
    """Where, radians from the axis."""


def formula_errors() -> list[FormulaError]:
    """Each formula at each distance, on this machine's GL.

    Raises ScreenError where there is no off-screen GL.
    """
    backend = OffscreenBackend()
    try:
        window = backend.open_window("formulas", (64, 64), None, SurfaceFormat(), WindowEvents())
        window.make_current()
        driver = CatchingDriver()
        return [_error(driver, name, distance) for name in FORMULAS for distance in DISTANCES]
    finally:
        backend.close()


def _error(driver: CatchingDriver, name: str, distance: float) -> FormulaError:
    places, phi = _places(distance)
    drawn = _drawn(driver, FORMULAS[name], places)
    exact = places.astype(float)
    rxy = np.hypot(exact[:, 0], exact[:, 1])
    with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
        true = exact[:, :2] / rxy[:, None] * (np.arctan2(rxy, -exact[:, 2]) / (np.pi / 2))[:, None]
        off = np.linalg.norm(drawn[:, :2].astype(float) / drawn[:, 3:] - true, axis=1)
    off = np.where(np.isfinite(off), off, np.inf)
    worst = int(off.argmax())
    return FormulaError(name, distance, float(off[worst]), float(phi[worst]))


def _places(distance: float) -> tuple[NDArray[np.float32], NDArray[np.float64]]:
    """(n, 4) points and (n,) their angles from the axis: dense near it, near the rim and straight behind."""
    close = np.geomspace(_NEAREST, np.pi / 2, _COUNT)
    phi = np.concatenate([close, np.pi - close[::-1]])
    theta = np.arange(len(phi)) * 2.399963229728653  # the golden angle: every heading comes
    points = np.stack([np.sin(phi) * np.cos(theta), np.sin(phi) * np.sin(theta), -np.cos(phi)], -1) * distance
    placed = np.column_stack([points, np.ones(len(points))]).astype(np.float32)
    exact = placed.astype(float)
    return placed, np.arctan2(np.hypot(exact[:, 0], exact[:, 1]), -exact[:, 2])


def _drawn(driver: CatchingDriver, bend: str, places: NDArray[np.float32]) -> NDArray[np.float32]:
    """(n, 4): gl_Position of each point."""
    text = f"#version 130\n{_LENS}{bend}\nvoid main() {{ gl_Position = bent(gl_Vertex); }}\n"
    shader, compiled = driver.glCreateShader(_VERTEX_SHADER), c_int()
    driver.glShaderSource(shader, 1, c_char_p(text.encode()), None)
    driver.glCompileShader(shader)
    driver.glGetShaderiv(shader, _COMPILE_STATUS, compiled)
    if not compiled:
        raise ShaderError("the driver refused a formula")
    program = driver.glCreateProgram()
    driver.glAttachShader(program, shader)
    driver.glLinkProgram(program)
    driver.glUseProgram(program)
    driver.glEnableClientState(_VERTEX_ARRAY)
    driver.glVertexPointer(4, _FLOAT, 0, places.ctypes.data_as(c_void_p))
    driver.glDrawArrays(_POINTS, 0, len(places))
    driver.glDisableClientState(_VERTEX_ARRAY)
    driver.glUseProgram(0)
    driver.glDeleteProgram(program)
    return driver.caught.pop().positions[:, 0]
