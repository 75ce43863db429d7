"""GL called straight, past PyOpenGL's wrappers, for our own questions and draws.

PyOpenGL checks glGetError after each call and converts each argument; ours are made between the program's
calls, many a frame, and must neither pay for that nor disturb the program's own error checks.
"""

from __future__ import annotations

import ctypes
import re
from collections.abc import Callable
from ctypes import POINTER, c_char_p, c_double, c_float, c_int, c_ssize_t, c_ubyte, c_uint, c_void_p
from functools import cached_property
from typing import Any

from domeshim.errors import DriverError

OLDEST_GL = (2, 1)
"""From here on the dome has the GLSL that it needs, 1.20."""
_RENDERER, _VERSION, _EXTENSIONS, _MAX_CLIP_PLANES, _RECTANGLE = 0x1F01, 0x1F02, 0x1F03, 0x0D32, 0x84F5
_INT, _UINT, _ENUM, _FLOAT, _POINTER = c_int, c_uint, c_uint, c_float, c_void_p

_SIGNATURES: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "glGetError": (_ENUM, ()),
    "glIsEnabled": (c_ubyte, (_ENUM,)),
    "glEnable": (None, (_ENUM,)),
    "glDisable": (None, (_ENUM,)),
    "glGetIntegerv": (None, (_ENUM, POINTER(c_int))),
    "glGetFloatv": (None, (_ENUM, POINTER(c_float))),
    "glGetDoublev": (None, (_ENUM, POINTER(c_double))),
    "glGetString": (c_char_p, (_ENUM,)),
    "glGetMaterialfv": (None, (_ENUM, _ENUM, POINTER(c_float))),
    "glGetMapiv": (None, (_ENUM, _ENUM, POINTER(c_int))),
    "glGetMapfv": (None, (_ENUM, _ENUM, POINTER(c_float))),
    "glGetMapdv": (None, (_ENUM, _ENUM, POINTER(c_double))),
    "glMaterialfv": (None, (_ENUM, _ENUM, POINTER(c_float))),
    "glGetLightfv": (None, (_ENUM, _ENUM, POINTER(c_float))),
    "glGetTexGeniv": (None, (_ENUM, _ENUM, POINTER(c_int))),
    "glGetTexLevelParameteriv": (None, (_ENUM, _INT, _ENUM, POINTER(c_int))),
    "glClipPlane": (None, (_ENUM, POINTER(c_double))),
    "glGetClipPlane": (None, (_ENUM, POINTER(c_double))),
    "glActiveTexture": (None, (_ENUM,)),
    "glViewport": (None, (_INT, _INT, _INT, _INT)),
    "glScissor": (None, (_INT, _INT, _INT, _INT)),
    "glPushAttrib": (None, (c_uint,)),
    "glPopAttrib": (None, ()),
    "glDrawArrays": (None, (_ENUM, _INT, _INT)),
    "glDrawElements": (None, (_ENUM, _INT, _ENUM, _POINTER)),
    "glDrawArraysInstanced": (None, (_ENUM, _INT, _INT, _INT)),
    "glDrawElementsInstanced": (None, (_ENUM, _INT, _ENUM, _POINTER, _INT)),
    "glInterleavedArrays": (None, (_ENUM, _INT, _POINTER)),
    "glMultiDrawArrays": (None, (_ENUM, POINTER(c_int), POINTER(c_int), _INT)),
    "glBegin": (None, (_ENUM,)),
    "glEnd": (None, ()),
    "glVertex3f": (None, (_FLOAT,) * 3),
    "glVertex4f": (None, (_FLOAT,) * 4),
    "glColor4f": (None, (_FLOAT,) * 4),
    "glNormal3f": (None, (_FLOAT,) * 3),
    "glMultiTexCoord4f": (None, (_ENUM, *(_FLOAT,) * 4)),
    "glSecondaryColor3f": (None, (_FLOAT,) * 3),
    "glFogCoordf": (None, (_FLOAT,)),
    "glEdgeFlag": (None, (c_ubyte,)),
    "glVertexPointer": (None, (_INT, _ENUM, _INT, _POINTER)),
    "glColorPointer": (None, (_INT, _ENUM, _INT, _POINTER)),
    "glNormalPointer": (None, (_ENUM, _INT, _POINTER)),
    "glTexCoordPointer": (None, (_INT, _ENUM, _INT, _POINTER)),
    "glSecondaryColorPointer": (None, (_INT, _ENUM, _INT, _POINTER)),
    "glFogCoordPointer": (None, (_ENUM, _INT, _POINTER)),
    "glEdgeFlagPointer": (None, (_INT, _POINTER)),
    "glEnableClientState": (None, (_ENUM,)),
    "glDisableClientState": (None, (_ENUM,)),
    "glClientActiveTexture": (None, (_ENUM,)),
    "glGenVertexArrays": (None, (_INT, POINTER(c_uint))),
    "glBindVertexArray": (None, (_UINT,)),
    "glDeleteVertexArrays": (None, (_INT, POINTER(c_uint))),
    "glNewList": (None, (_UINT, _ENUM)),
    "glEndList": (None, ()),
    "glCallList": (None, (_UINT,)),
    "glIsList": (c_ubyte, (_UINT,)),
    "glGenLists": (_UINT, (_INT,)),
    "glDeleteLists": (None, (_UINT, _INT)),
    "glClearColor": (None, (_FLOAT,) * 4),
    "glColorMask": (None, (c_ubyte,) * 4),
    "glClear": (None, (c_uint,)),
    "glDrawBuffer": (None, (_ENUM,)),
    "glDepthMask": (None, (c_ubyte,)),
    "glDepthFunc": (None, (_ENUM,)),
    "glDepthRange": (None, (c_double, c_double)),
    "glStencilFunc": (None, (_ENUM, _INT, _UINT)),
    "glStencilOp": (None, (_ENUM, _ENUM, _ENUM)),
    "glMatrixMode": (None, (_ENUM,)),
    "glLoadIdentity": (None, ()),
    "glTranslatef": (None, (_FLOAT,) * 3),
    "glLoadMatrixd": (None, (POINTER(c_double),)),
    "glTexEnvi": (None, (_ENUM, _ENUM, _INT)),
    "glGenerateMipmap": (None, (_ENUM,)),
    "glWindowPos3f": (None, (_FLOAT,) * 3),
    "glRasterPos2f": (None, (_FLOAT,) * 2),
    "glBitmap": (None, (_INT, _INT, _FLOAT, _FLOAT, _FLOAT, _FLOAT, _POINTER)),
    "glReadPixels": (None, (_INT, _INT, _INT, _INT, _ENUM, _ENUM, _POINTER)),
    "glDrawPixels": (None, (_INT, _INT, _ENUM, _ENUM, _POINTER)),
    "glPixelZoom": (None, (_FLOAT, _FLOAT)),
    "glPixelStorei": (None, (_ENUM, _INT)),
    "glPixelTransferf": (None, (_ENUM, _FLOAT)),
    "glPushClientAttrib": (None, (c_uint,)),
    "glPopClientAttrib": (None, ()),
    "glGenTextures": (None, (_INT, POINTER(c_uint))),
    "glBindTexture": (None, (_ENUM, _UINT)),
    "glDeleteTextures": (None, (_INT, POINTER(c_uint))),
    "glTexParameteri": (None, (_ENUM, _ENUM, _INT)),
    "glTexImage2D": (None, (_ENUM, _INT, _INT, _INT, _INT, _INT, _ENUM, _ENUM, _POINTER)),
    "glCopyTexImage2D": (None, (_ENUM, _INT, _ENUM, *(_INT,) * 5)),
    "glGenFramebuffers": (None, (_INT, POINTER(c_uint))),
    "glBindFramebuffer": (None, (_ENUM, _UINT)),
    "glDeleteFramebuffers": (None, (_INT, POINTER(c_uint))),
    "glBlitFramebuffer": (None, (*(_INT,) * 8, c_uint, _ENUM)),
    "glCheckFramebufferStatus": (_ENUM, (_ENUM,)),
    "glGenRenderbuffers": (None, (_INT, POINTER(c_uint))),
    "glBindRenderbuffer": (None, (_ENUM, _UINT)),
    "glDeleteRenderbuffers": (None, (_INT, POINTER(c_uint))),
    "glRenderbufferStorageMultisample": (None, (_ENUM, _INT, _ENUM, _INT, _INT)),
    "glFramebufferRenderbuffer": (None, (_ENUM, _ENUM, _ENUM, _UINT)),
    "glFramebufferTexture2D": (None, (_ENUM, _ENUM, _ENUM, _UINT, _INT)),
    "glPolygonMode": (None, (_ENUM, _ENUM)),
    "glLogicOp": (None, (_ENUM,)),
    "glRenderMode": (_INT, (_ENUM,)),
    "glUseProgram": (None, (_UINT,)),
    "glCreateShader": (_UINT, (_ENUM,)),
    "glDeleteShader": (None, (_UINT,)),
    "glShaderSource": (None, (_UINT, _INT, POINTER(c_char_p), POINTER(c_int))),
    "glCompileShader": (None, (_UINT,)),
    "glGetShaderiv": (None, (_UINT, _ENUM, POINTER(c_int))),
    "glGetShaderInfoLog": (None, (_UINT, _INT, POINTER(c_int), c_char_p)),
    "glGetShaderSource": (None, (_UINT, _INT, POINTER(c_int), c_char_p)),
    "glCreateProgram": (_UINT, ()),
    "glDeleteProgram": (None, (_UINT,)),
    "glAttachShader": (None, (_UINT, _UINT)),
    "glGetAttachedShaders": (None, (_UINT, _INT, POINTER(c_int), POINTER(c_uint))),
    "glLinkProgram": (None, (_UINT,)),
    "glGetProgramiv": (None, (_UINT, _ENUM, POINTER(c_int))),
    "glGetProgramInfoLog": (None, (_UINT, _INT, POINTER(c_int), c_char_p)),
    "glGetUniformLocation": (_INT, (_UINT, c_char_p)),
    "glGetActiveUniform": (
        None,
        (_UINT, _UINT, _INT, POINTER(c_int), POINTER(c_int), POINTER(_ENUM), c_char_p),
    ),
    "glGetUniformfv": (None, (_UINT, _INT, POINTER(c_float))),
    "glGetUniformiv": (None, (_UINT, _INT, POINTER(c_int))),
    "glGetUniformuiv": (None, (_UINT, _INT, POINTER(c_uint))),
    "glGetActiveUniformBlockName": (None, (_UINT, _UINT, _INT, POINTER(c_int), c_char_p)),
    "glGetActiveUniformBlockiv": (None, (_UINT, _UINT, _ENUM, POINTER(c_int))),
    "glGetUniformBlockIndex": (_UINT, (_UINT, c_char_p)),
    "glUniformBlockBinding": (None, (_UINT, _UINT, _UINT)),
    "glGetActiveAttrib": (
        None,
        (_UINT, _UINT, _INT, POINTER(c_int), POINTER(c_int), POINTER(_ENUM), c_char_p),
    ),
    "glGetAttribLocation": (_INT, (_UINT, c_char_p)),
    "glGetFragDataLocation": (_INT, (_UINT, c_char_p)),
    "glBindFragDataLocation": (None, (_UINT, _UINT, c_char_p)),
    "glGenQueries": (None, (_INT, POINTER(c_uint))),
    "glBeginQuery": (None, (_ENUM, _UINT)),
    "glEndQuery": (None, (_ENUM,)),
    "glGetQueryObjectuiv": (None, (_UINT, _ENUM, POINTER(c_uint))),
    "glPatchParameteri": (None, (_ENUM, _INT)),
    "glTransformFeedbackVaryings": (None, (_UINT, _INT, POINTER(c_char_p), _ENUM)),
    "glBeginTransformFeedback": (None, (_ENUM,)),
    "glEndTransformFeedback": (None, ()),
    "glBindBufferBase": (None, (_ENUM, _UINT, _UINT)),
    **{f"glUniform{n}fv": (None, (_INT, _INT, POINTER(c_float))) for n in range(1, 5)},
    **{f"glUniform{n}iv": (None, (_INT, _INT, POINTER(c_int))) for n in range(1, 5)},
    **{f"glUniform{n}uiv": (None, (_INT, _INT, POINTER(c_uint))) for n in range(1, 5)},
    **{
        f"glUniformMatrix{n}fv": (None, (_INT, _INT, c_ubyte, POINTER(c_float)))
        for n in (2, 3, 4, "2x3", "2x4", "3x2", "3x4", "4x2", "4x3")
    },
    "glBindAttribLocation": (None, (_UINT, _UINT, c_char_p)),
    "glVertexAttribPointer": (None, (_UINT, _INT, _ENUM, c_ubyte, _INT, _POINTER)),
    "glEnableVertexAttribArray": (None, (_UINT,)),
    "glDisableVertexAttribArray": (None, (_UINT,)),
    "glGenBuffers": (None, (_INT, POINTER(c_uint))),
    "glDeleteBuffers": (None, (_INT, POINTER(c_uint))),
    "glGetBufferSubData": (None, (_ENUM, c_ssize_t, c_ssize_t, _POINTER)),
    "glGetPointerv": (None, (_ENUM, POINTER(c_void_p))),
    "glBindBuffer": (None, (_ENUM, _UINT)),
    "glBufferData": (None, (_ENUM, c_ssize_t, _POINTER, _ENUM)),
}

_ONE_INT = c_int * 1
_EXTENSION_OF = {
    "glBindVertexArray": "GL_ARB_vertex_array_object",
    "glBindFramebuffer": "GL_ARB_framebuffer_object",
}
"""What OpenGL 2 has by these names: some platforms hand out an address for every name that they know."""


class Driver:
    """The GL entry points by name, looked up once; attributes are ctypes functions.

    Raises DriverError at the first use of an entry point that this GL does not have.
    """

    def __getattr__(self, name: str) -> Any:
        function = _look_up(name)
        setattr(self, name, function)
        return function

    def has(self, name: str) -> bool:
        """This GL has the entry point."""
        if name in _EXTENSION_OF and self.legacy and not self.names(_EXTENSION_OF[name]):
            return False
        try:
            getattr(self, name)
        except DriverError:
            return False
        return True

    @property
    def renderer(self) -> bytes:
        """What draws, by the driver's own name for it."""
        return bytes(self.glGetString(_RENDERER) or b"")

    @property
    def version(self) -> tuple[int, int]:
        """The current context's version of GL, as in (4, 5)."""
        found = re.match(rb"(\d+)\.(\d+)", self.glGetString(_VERSION) or b"")
        return (int(found[1]), int(found[2])) if found else (0, 0)

    @property
    def current(self) -> bool:
        """A context is current: calls of GL have somewhere to go."""
        return bool(self.glGetString(_VERSION))

    @cached_property
    def legacy(self) -> bool:
        """This is OpenGL 2: no clip distances, no array or framebuffer objects but by extensions."""
        return self.version < (3, 0)

    @cached_property
    def clip_planes(self) -> int:
        """How many clip planes GL has, up to 8."""
        return min(self.integer(_MAX_CLIP_PLANES), 8)

    @cached_property
    def texture_targets(self) -> tuple[int, ...]:
        """The kinds of texture that the fixed pipeline has: 2D, 1D, 3D, cube map, rectangle."""
        targets = (0x0DE1, 0x0DE0, 0x806F, 0x8513, _RECTANGLE)
        lacks = self.legacy and not self.names("GL_ARB_texture_rectangle")
        return targets[:-1] if lacks else targets

    def names(self, extension: str) -> bool:
        """This GL lists the extension."""
        return extension.encode() in (self.glGetString(_EXTENSIONS) or b"").split()

    def require(self, version: tuple[int, int], what: str = "the dome") -> None:
        """Raise DriverError where the current context's GL is older than what this needs."""
        if self.version < version:
            found, needed = (".".join(map(str, numbers)) for numbers in (self.version, version))
            raise DriverError(f"this machine's OpenGL is {found}; {what} needs {needed} or later")

    def integers(self, name: int, count: int) -> tuple[int, ...]:
        """What glGetIntegerv says, as so many integers."""
        values = (c_int * count)()
        self.glGetIntegerv(name, values)
        return tuple(values[:])  # of ctypes' own arrays tuple() takes several times as long

    def integer(self, name: int) -> int:
        """What glGetIntegerv says, for a single value."""
        values = _ONE_INT()
        self.glGetIntegerv(name, values)
        return values[0]

    def doubles(self, name: int, count: int) -> tuple[float, ...]:
        """What glGetDoublev says, as so many numbers."""
        values = (c_double * count)()
        self.glGetDoublev(name, values)
        return tuple(values[:])

    def address(self, name: str) -> int:
        """Where the entry point of any name is; 0 where this GL has none."""
        return _address(name)


def _look_up(name: str) -> Any:
    if name not in _SIGNATURES:
        raise AttributeError(name)
    result, arguments = _SIGNATURES[name]
    prototype = ctypes.CFUNCTYPE(result, *arguments)
    address = _address(name)
    if not address:
        raise DriverError(f"this machine's OpenGL has no {name}; run `domeshim doctor` to see what it has")
    return prototype(address)


def callable_from_c(name: str, call: Callable[..., Any]) -> Any:
    """A function that C code may call instead of the entry point of this name, as long as it is kept."""
    result, arguments = _SIGNATURES[name]
    return ctypes.CFUNCTYPE(result, *arguments)(call)


def _address(name: str) -> int:
    from OpenGL.platform import PLATFORM  # noqa: PLC0415 - only once the program has a window

    try:
        return ctypes.cast(getattr(PLATFORM.GL, name), c_void_p).value or 0
    except AttributeError:
        return int(PLATFORM.getExtensionProcedure(name.encode()) or 0)
