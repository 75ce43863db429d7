"""What a vertex shader gives out, caught by transform feedback."""

import ctypes

import numpy as np
from OpenGL import GL

from domeshim.shading.program import Uniforms


def caught(driver, text, vertices, uniforms=None, coordinates=()):
    """gl_Position of each vertex. vertices: (n, 4) float32, as are the texture coordinates -> (n, 4)."""
    program, shader = GL.glCreateProgram(), GL.glCreateShader(GL.GL_VERTEX_SHADER)
    GL.glShaderSource(shader, text)
    GL.glCompileShader(shader)
    GL.glAttachShader(program, shader)
    name = ctypes.create_string_buffer(b"gl_Position")
    GL.glTransformFeedbackVaryings(
        program,
        1,
        (ctypes.POINTER(ctypes.c_char) * 1)(ctypes.cast(name, ctypes.POINTER(ctypes.c_char))),
        GL.GL_INTERLEAVED_ATTRIBS,
    )
    GL.glLinkProgram(program)
    GL.glUseProgram(program)
    sender = Uniforms(driver, program)
    for uniform, values in (uniforms or {}).items():
        sender.set(uniform, values)
    buffer = GL.glGenBuffers(1)
    GL.glBindBuffer(GL.GL_TRANSFORM_FEEDBACK_BUFFER, buffer)
    GL.glBufferData(GL.GL_TRANSFORM_FEEDBACK_BUFFER, vertices.nbytes, None, GL.GL_STREAM_READ)
    GL.glBindBufferBase(GL.GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer)
    GL.glPushClientAttrib(GL.GL_CLIENT_VERTEX_ARRAY_BIT)
    GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
    GL.glVertexPointer(4, GL.GL_FLOAT, 0, vertices)
    for unit, values in enumerate(coordinates):
        GL.glClientActiveTexture(GL.GL_TEXTURE0 + unit)
        GL.glEnableClientState(GL.GL_TEXTURE_COORD_ARRAY)
        GL.glTexCoordPointer(4, GL.GL_FLOAT, 0, values)
    GL.glEnable(GL.GL_RASTERIZER_DISCARD)
    GL.glBeginTransformFeedback(GL.GL_POINTS)
    GL.glDrawArrays(GL.GL_POINTS, 0, len(vertices))
    GL.glEndTransformFeedback()
    GL.glDisable(GL.GL_RASTERIZER_DISCARD)
    GL.glPopClientAttrib()
    data = GL.glGetBufferSubData(GL.GL_TRANSFORM_FEEDBACK_BUFFER, 0, vertices.nbytes)
    GL.glUseProgram(0)
    GL.glDeleteBuffers(1, [buffer])
    GL.glDeleteProgram(program)
    return np.frombuffer(bytes(data), np.float32).reshape(-1, 4)
