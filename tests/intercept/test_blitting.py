"""glBlitFramebuffer between the program's window and framebuffers of its own."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from tests.intercept.test_copying import PLAIN, unlike
from tests.intercept.test_reading import SIZE, scene
from tests.pictures.beside import GL, Beside


@pytest.fixture(scope="module")
def beside(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Beside]:
    pair = Beside(Path(tmp_path_factory.getbasetemp()) / "differences")
    yield pair
    pair.close()


def own_framebuffer(gl: GL, width: int, height: int, samples: int = 0) -> int:
    """A framebuffer of the program's own with colours and depths, bound."""
    framebuffer, (colours, depths) = gl.glGenFramebuffers(1), gl.glGenRenderbuffers(2)
    gl.glBindFramebuffer(gl.GL_FRAMEBUFFER, framebuffer)
    for name, kind, place in (
        (colours, gl.GL_RGBA8, gl.GL_COLOR_ATTACHMENT0),
        (depths, gl.GL_DEPTH_COMPONENT32F, gl.GL_DEPTH_ATTACHMENT),
    ):
        gl.glBindRenderbuffer(gl.GL_RENDERBUFFER, name)
        gl.glRenderbufferStorageMultisample(gl.GL_RENDERBUFFER, samples, kind, width, height)
        gl.glFramebufferRenderbuffer(gl.GL_FRAMEBUFFER, place, gl.GL_RENDERBUFFER, name)
    assert gl.glCheckFramebufferStatus(gl.GL_FRAMEBUFFER) == gl.GL_FRAMEBUFFER_COMPLETE
    return int(framebuffer)


def quarters(gl: GL) -> None:
    """Four colours over what is bound, 64 pixels square."""
    gl.glEnable(gl.GL_SCISSOR_TEST)
    for x, y, colour in ((0, 0, (1, 0, 0)), (32, 0, (0, 1, 0)), (0, 32, (0, 0, 1)), (32, 32, (1, 1, 0))):
        gl.glScissor(x, y, 32, 32)
        gl.glClearColor(*colour, 1)
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)
    gl.glDisable(gl.GL_SCISSOR_TEST)
    gl.glClearColor(0, 0, 0, 1)


TURNS = [(0, 0, 64, 64), (64, 0, 0, 64), (0, 64, 64, 0)]


@pytest.mark.parametrize("samples", [0, 4])
@pytest.mark.parametrize("source", TURNS, ids=["as it is", "mirrored", "upside down"])
def test_into_the_window(beside: Beside, source: tuple[int, ...], samples: int) -> None:
    """Nothing that the program has set for its draws matters."""
    if samples and source != TURNS[0]:
        pytest.skip("GL refuses it")

    def show(gl: GL) -> int:
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)
        framebuffer = own_framebuffer(gl, 64, 64, samples)
        quarters(gl)
        # GL brings samples together only where the sizes are the same
        target = (60, 40, 124, 104) if samples else (30, 40, 220, 200)
        gl.glBindFramebuffer(gl.GL_READ_FRAMEBUFFER, framebuffer)
        gl.glBindFramebuffer(gl.GL_DRAW_FRAMEBUFFER, 0)
        for capability in (gl.GL_BLEND, gl.GL_LIGHTING, gl.GL_FOG, gl.GL_CULL_FACE, gl.GL_ALPHA_TEST):
            gl.glEnable(capability)
        gl.glAlphaFunc(gl.GL_NEVER, 0)
        gl.glMatrixMode(gl.GL_PROJECTION)
        gl.gluPerspective(1.0, 1, 1, 10)
        gl.glBlitFramebuffer(*source, *target, gl.GL_COLOR_BUFFER_BIT, gl.GL_NEAREST)
        gl.glBindFramebuffer(gl.GL_FRAMEBUFFER, 0)
        return int(gl.glIsEnabled(gl.GL_BLEND)) + int(gl.glGetError())

    assert beside.equal(show, name="blit", wrong=0.03) == 1


def test_into_the_window_under_a_program(beside: Beside) -> None:
    def show(gl: GL) -> bool:
        program = gl.shaders.compileProgram(
            gl.shaders.compileShader("void main() { gl_Position = gl_Vertex; }", gl.GL_VERTEX_SHADER),
            gl.shaders.compileShader("void main() { gl_FragColor = vec4(1.0); }", gl.GL_FRAGMENT_SHADER),
        )
        gl.glUseProgram(program)
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)
        framebuffer = own_framebuffer(gl, 64, 64)
        quarters(gl)
        gl.glBindFramebuffer(gl.GL_READ_FRAMEBUFFER, framebuffer)
        gl.glBindFramebuffer(gl.GL_DRAW_FRAMEBUFFER, 0)
        gl.glBlitFramebuffer(0, 0, 64, 64, 30, 40, 220, 200, gl.GL_COLOR_BUFFER_BIT, gl.GL_NEAREST)
        gl.glBindFramebuffer(gl.GL_FRAMEBUFFER, 0)
        bound = gl.glGetIntegerv(gl.GL_CURRENT_PROGRAM) == program
        gl.glRectf(0.5, 0.5, 0.7, 0.7)
        gl.glUseProgram(0)
        return bool(bound)

    import OpenGL.GL.shaders

    beside.stock.shaders = beside.dome.shaders = OpenGL.GL.shaders
    assert beside.equal(show, name="blit under a program", wrong=0.03) is True


def test_out_of_the_window(beside: Beside) -> None:
    """Mirrored, in the middle of the larger framebuffer."""

    def take(gl: GL) -> np.ndarray:
        scene(gl)
        framebuffer = own_framebuffer(gl, *SIZE)
        gl.glClearColor(0, 0, 0, 0)
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)
        gl.glBindFramebuffer(gl.GL_READ_FRAMEBUFFER, 0)
        gl.glBindFramebuffer(gl.GL_DRAW_FRAMEBUFFER, framebuffer)
        box = (260, 40, 60, 200, 60, 40, 260, 200)
        gl.glBlitFramebuffer(*box, gl.GL_COLOR_BUFFER_BIT, gl.GL_NEAREST)
        gl.glBindFramebuffer(gl.GL_READ_FRAMEBUFFER, framebuffer)
        gl.glPixelStorei(gl.GL_PACK_ALIGNMENT, 1)
        colours = gl.glReadPixels(0, 0, *SIZE, gl.GL_RGB, gl.GL_UNSIGNED_BYTE)
        gl.glBindFramebuffer(gl.GL_FRAMEBUFFER, 0)
        return np.frombuffer(colours, np.uint8).reshape(SIZE[1], SIZE[0], 3)

    monitor = beside.monitor(take, SIZE).answer
    assert len(np.unique(monitor.reshape(-1, 3), axis=0)) >= 3
    assert unlike(beside.through_dome(take, SIZE, **PLAIN).answer, monitor) < 0.02
