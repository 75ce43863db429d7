"""The whole of GLUT, over glfw or off screen: `from domeshim.GLUT import *` in place of OpenGL.GLUT.

Everything that OpenGL.GLUT offers to programs is here under the same name. GLUT's memory is in state.py;
what a program registers in callbacks.py is called from mainloop.py: events.py -> reactions.py -> dispatch.py.
"""

# ruff: noqa: I001 - one name a line would fill ten screens
# fmt: off

from __future__ import annotations

import ctypes  # OpenGL.GLUT passes these modules on, and programs have come to rely on it
import os
import sys
import traceback

from OpenGL.raw.GL._types import (
    GLDEBUGPROC, GLDEBUGPROCAMD, GLDEBUGPROCARB, GLDEBUGPROCKHR, GL_BYTE, GL_CHAR, GL_DOUBLE, GL_FALSE,
    GL_FIXED, GL_FLOAT, GL_HALF_FLOAT, GL_HALF_NV, GL_INT, GL_SHORT, GL_TRUE, GL_UNSIGNED_BYTE,
    GL_UNSIGNED_INT, GL_UNSIGNED_INT64, GL_UNSIGNED_SHORT, GL_VOID_P, GLbitfield, GLboolean, GLbyte, GLchar,
    GLcharARB, GLclampd, GLclampf, GLclampx, GLdouble, GLdouble_2, GLdouble_3, GLdouble_4, GLeglImageOES,
    GLenum, GLfixed, GLfloat, GLfloat_2, GLfloat_3, GLfloat_4, GLhalfARB, GLhalfNV, GLhandle, GLhandleARB,
    GLint, GLint64, GLint64EXT, GLintptr, GLintptrARB, GLshort, GLsizei, GLsizeiptr, GLsizeiptrARB, GLsync,
    GLubyte, GLubyte_3, GLuint, GLuint64, GLuint64EXT, GLulong, GLushort, GLvdpauSurfaceNV, GLvoid, GLvoidp,
)
from OpenGL.constant import Constant

from domeshim import startup
from domeshim.GLUT.callbacks import (
    glutButtonBoxFunc, glutCloseFunc, glutDialsFunc, glutDisplayFunc, glutEntryFunc, glutIgnoreKeyRepeat,
    glutKeyboardFunc, glutKeyboardUpFunc, glutMotionFunc,
    glutMouseFunc, glutMouseWheelFunc, glutOverlayDisplayFunc, glutPassiveMotionFunc, glutPositionFunc,
    glutReshapeFunc, glutSetKeyRepeat, glutSpaceballButtonFunc, glutSpaceballMotionFunc,
    glutSpaceballRotateFunc, glutSpecialFunc, glutSpecialUpFunc, glutTabletButtonFunc, glutTabletMotionFunc,
    glutVisibilityFunc, glutWMCloseFunc, glutWindowStatusFunc,
)
from domeshim.GLUT.closing import (
    fgDeinitialize,
)
from domeshim.GLUT.constants import (
    GLUT_3_2_CORE_PROFILE, GLUT_ACCUM, GLUT_ACTION_CONTINUE_EXECUTION, GLUT_ACTION_EXIT,
    GLUT_ACTION_GLUTMAINLOOP_RETURNS, GLUT_ACTION_ON_WINDOW_CLOSE, GLUT_ACTIVE_ALT, GLUT_ACTIVE_CTRL,
    GLUT_ACTIVE_SHIFT, GLUT_ACTIVE_SUPER, GLUT_ALLOW_DIRECT_CONTEXT, GLUT_ALPHA, GLUT_API_VERSION, GLUT_AUX,
    GLUT_AUX1, GLUT_AUX2, GLUT_AUX3, GLUT_AUX4, GLUT_BLUE, GLUT_BORDERLESS, GLUT_CAPTIONLESS,
    GLUT_COMPATIBILITY_PROFILE, GLUT_CORE_PROFILE, GLUT_CREATE_NEW_CONTEXT, GLUT_CURSOR_BOTTOM_LEFT_CORNER,
    GLUT_CURSOR_BOTTOM_RIGHT_CORNER, GLUT_CURSOR_BOTTOM_SIDE, GLUT_CURSOR_CROSSHAIR, GLUT_CURSOR_CYCLE,
    GLUT_CURSOR_DESTROY, GLUT_CURSOR_FULL_CROSSHAIR, GLUT_CURSOR_HELP, GLUT_CURSOR_INFO, GLUT_CURSOR_INHERIT,
    GLUT_CURSOR_LEFT_ARROW, GLUT_CURSOR_LEFT_RIGHT, GLUT_CURSOR_LEFT_SIDE, GLUT_CURSOR_NONE,
    GLUT_CURSOR_RIGHT_ARROW, GLUT_CURSOR_RIGHT_SIDE, GLUT_CURSOR_SPRAY, GLUT_CURSOR_TEXT,
    GLUT_CURSOR_TOP_LEFT_CORNER, GLUT_CURSOR_TOP_RIGHT_CORNER, GLUT_CURSOR_TOP_SIDE, GLUT_CURSOR_UP_DOWN,
    GLUT_CURSOR_WAIT, GLUT_DEBUG, GLUT_DEPTH, GLUT_DEVICE_IGNORE_KEY_REPEAT, GLUT_DEVICE_KEY_REPEAT,
    GLUT_DIRECT_RENDERING, GLUT_DISPLAY_MODE_POSSIBLE, GLUT_DOUBLE, GLUT_DOWN, GLUT_ELAPSED_TIME,
    GLUT_ENTERED, GLUT_FORCE_DIRECT_CONTEXT, GLUT_FORCE_INDIRECT_CONTEXT, GLUT_FORWARD_COMPATIBLE,
    GLUT_FULLY_COVERED, GLUT_FULLY_RETAINED, GLUT_FULL_SCREEN, GLUT_GAME_MODE_ACTIVE,
    GLUT_GAME_MODE_DISPLAY_CHANGED, GLUT_GAME_MODE_HEIGHT, GLUT_GAME_MODE_PIXEL_DEPTH,
    GLUT_GAME_MODE_POSSIBLE, GLUT_GAME_MODE_REFRESH_RATE, GLUT_GAME_MODE_WIDTH, GLUT_GREEN,
    GLUT_HAS_DIAL_AND_BUTTON_BOX, GLUT_HAS_JOYSTICK, GLUT_HAS_KEYBOARD, GLUT_HAS_MOUSE, GLUT_HAS_OVERLAY,
    GLUT_HAS_SPACEBALL, GLUT_HAS_TABLET, GLUT_HIDDEN, GLUT_INDEX, GLUT_INIT_DISPLAY_MODE, GLUT_INIT_FLAGS,
    GLUT_INIT_MAJOR_VERSION, GLUT_INIT_MINOR_VERSION, GLUT_INIT_PROFILE, GLUT_INIT_STATE,
    GLUT_INIT_WINDOW_HEIGHT, GLUT_INIT_WINDOW_WIDTH, GLUT_INIT_WINDOW_X, GLUT_INIT_WINDOW_Y,
    GLUT_JOYSTICK_AXES, GLUT_JOYSTICK_BUTTONS, GLUT_JOYSTICK_BUTTON_A, GLUT_JOYSTICK_BUTTON_B,
    GLUT_JOYSTICK_BUTTON_C, GLUT_JOYSTICK_BUTTON_D, GLUT_JOYSTICK_POLL_RATE, GLUT_KEY_ALT_L, GLUT_KEY_ALT_R,
    GLUT_KEY_BEGIN, GLUT_KEY_CTRL_L, GLUT_KEY_CTRL_R, GLUT_KEY_DELETE, GLUT_KEY_DOWN, GLUT_KEY_END,
    GLUT_KEY_F1, GLUT_KEY_F10, GLUT_KEY_F11, GLUT_KEY_F12, GLUT_KEY_F2, GLUT_KEY_F3, GLUT_KEY_F4, GLUT_KEY_F5,
    GLUT_KEY_F6, GLUT_KEY_F7, GLUT_KEY_F8, GLUT_KEY_F9, GLUT_KEY_HOME, GLUT_KEY_INSERT, GLUT_KEY_LEFT,
    GLUT_KEY_NUM_LOCK, GLUT_KEY_PAGE_DOWN, GLUT_KEY_PAGE_UP, GLUT_KEY_REPEAT_DEFAULT, GLUT_KEY_REPEAT_OFF,
    GLUT_KEY_REPEAT_ON, GLUT_KEY_RIGHT, GLUT_KEY_SHIFT_L, GLUT_KEY_SHIFT_R, GLUT_KEY_UP, GLUT_LAYER_IN_USE,
    GLUT_LEFT, GLUT_LEFT_BUTTON, GLUT_LUMINANCE, GLUT_MENU_IN_USE, GLUT_MENU_NOT_IN_USE, GLUT_MENU_NUM_ITEMS,
    GLUT_MIDDLE_BUTTON, GLUT_MULTISAMPLE, GLUT_NORMAL, GLUT_NORMAL_DAMAGED, GLUT_NOT_VISIBLE,
    GLUT_NO_RECOVERY, GLUT_NUM_BUTTON_BOX_BUTTONS, GLUT_NUM_DIALS, GLUT_NUM_MOUSE_BUTTONS,
    GLUT_NUM_SPACEBALL_BUTTONS, GLUT_NUM_TABLET_BUTTONS, GLUT_OVERLAY, GLUT_OVERLAY_DAMAGED,
    GLUT_OVERLAY_POSSIBLE, GLUT_OWNS_JOYSTICK, GLUT_PARTIALLY_RETAINED, GLUT_RED, GLUT_RENDERING_CONTEXT,
    GLUT_RGB, GLUT_RGBA, GLUT_RIGHT_BUTTON, GLUT_SCREEN_HEIGHT, GLUT_SCREEN_HEIGHT_MM, GLUT_SCREEN_WIDTH,
    GLUT_SCREEN_WIDTH_MM, GLUT_SINGLE, GLUT_SRGB, GLUT_STENCIL, GLUT_STEREO, GLUT_TRANSPARENT_INDEX,
    GLUT_TRY_DIRECT_CONTEXT, GLUT_UP, GLUT_USE_CURRENT_CONTEXT, GLUT_VERSION, GLUT_VIDEO_RESIZE_HEIGHT,
    GLUT_VIDEO_RESIZE_HEIGHT_DELTA, GLUT_VIDEO_RESIZE_IN_USE, GLUT_VIDEO_RESIZE_POSSIBLE,
    GLUT_VIDEO_RESIZE_WIDTH, GLUT_VIDEO_RESIZE_WIDTH_DELTA, GLUT_VIDEO_RESIZE_X, GLUT_VIDEO_RESIZE_X_DELTA,
    GLUT_VIDEO_RESIZE_Y, GLUT_VIDEO_RESIZE_Y_DELTA, GLUT_VISIBLE, GLUT_WINDOW_ACCUM_ALPHA_SIZE,
    GLUT_WINDOW_ACCUM_BLUE_SIZE, GLUT_WINDOW_ACCUM_GREEN_SIZE, GLUT_WINDOW_ACCUM_RED_SIZE,
    GLUT_WINDOW_ALPHA_SIZE, GLUT_WINDOW_BLUE_SIZE, GLUT_WINDOW_BORDER_WIDTH, GLUT_WINDOW_BUFFER_SIZE,
    GLUT_WINDOW_COLORMAP_SIZE, GLUT_WINDOW_CURSOR, GLUT_WINDOW_DEPTH_SIZE, GLUT_WINDOW_DOUBLEBUFFER,
    GLUT_WINDOW_FORMAT_ID, GLUT_WINDOW_GREEN_SIZE, GLUT_WINDOW_HEADER_HEIGHT, GLUT_WINDOW_HEIGHT,
    GLUT_WINDOW_NUM_CHILDREN, GLUT_WINDOW_NUM_SAMPLES, GLUT_WINDOW_PARENT, GLUT_WINDOW_RED_SIZE,
    GLUT_WINDOW_RGBA, GLUT_WINDOW_STENCIL_SIZE, GLUT_WINDOW_STEREO, GLUT_WINDOW_WIDTH, GLUT_WINDOW_X,
    GLUT_WINDOW_Y, GLUT_XLIB_IMPLEMENTATION,
)
from domeshim.GLUT.fonts import (
    GLUT_BITMAP_8_BY_13, GLUT_BITMAP_9_BY_15, GLUT_BITMAP_HELVETICA_10, GLUT_BITMAP_HELVETICA_12,
    GLUT_BITMAP_HELVETICA_18, GLUT_BITMAP_TIMES_ROMAN_10, GLUT_BITMAP_TIMES_ROMAN_24, GLUT_STROKE_MONO_ROMAN,
    GLUT_STROKE_ROMAN, glutBitmapCharacter, glutBitmapHeight, glutBitmapLength, glutBitmapString,
    glutBitmapWidth, glutStrokeCharacter, glutStrokeHeight, glutStrokeLength, glutStrokeLengthf,
    glutStrokeString, glutStrokeWidth, glutStrokeWidthf,
)
from domeshim.GLUT.initialise import (
    glutInit, glutInitContextFlags, glutInitContextProfile, glutInitContextVersion, glutInitDisplayMode,
    glutInitDisplayString, glutInitErrorFunc, glutInitWarningFunc, glutInitWindowPosition, glutInitWindowSize,
)
from domeshim.GLUT.joystick import (
    glutForceJoystickFunc, glutJoystickFunc,
)
from domeshim.GLUT.mainloop import (
    glutCheckLoop, glutExit, glutIdleFunc, glutLeaveMainLoop, glutMainLoop, glutMainLoopEvent,
    glutSwapBuffers, glutTimerFunc,
)
from domeshim.GLUT.menus import (
    glutAddMenuEntry, glutAddSubMenu, glutAttachMenu, glutChangeToMenuEntry, glutChangeToSubMenu,
    glutCreateMenu, glutDestroyMenu, glutDetachMenu, glutGetMenu, glutGetMenuData, glutMenuDestroyFunc,
    glutMenuStateFunc, glutMenuStatusFunc, glutRemoveMenuItem, glutSetMenu, glutSetMenuData,
)
from domeshim.GLUT.modes import (
    glutCopyColormap, glutEnterGameMode, glutEstablishOverlay, glutGameModeGet, glutGameModeString,
    glutGetColor, glutHideOverlay, glutLeaveGameMode, glutPostOverlayRedisplay,
    glutPostWindowOverlayRedisplay, glutRemoveOverlay, glutSetColor, glutSetupVideoResizing, glutShowOverlay,
    glutStopVideoResizing, glutUseLayer, glutVideoPan, glutVideoResize, glutVideoResizeGet,
)
from domeshim.GLUT.queries import (
    glutDeviceGet, glutExtensionSupported, glutGet, glutGetModeValues, glutGetModifiers, glutGetProcAddress,
    glutLayerGet, glutReportErrors, glutSetOption,
)
from domeshim.GLUT.solids import (
    glutSolidCone, glutSolidCube, glutSolidCylinder, glutSolidDodecahedron, glutSolidIcosahedron,
    glutSolidOctahedron, glutSolidRhombicDodecahedron, glutSolidSierpinskiSponge, glutSolidSphere,
    glutSolidTeacup, glutSolidTeapot, glutSolidTeaspoon, glutSolidTetrahedron, glutSolidTorus, glutWireCone,
    glutWireCube, glutWireCylinder, glutWireDodecahedron, glutWireIcosahedron, glutWireOctahedron,
    glutWireRhombicDodecahedron, glutWireSierpinskiSponge, glutWireSphere, glutWireTeacup, glutWireTeapot,
    glutWireTeaspoon, glutWireTetrahedron, glutWireTorus,
)
from domeshim.GLUT.windows import (
    glutCreateSubWindow, glutCreateWindow, glutDestroyWindow, glutFullScreen, glutFullScreenToggle,
    glutGetWindow, glutGetWindowData, glutHideWindow, glutIconifyWindow, glutLeaveFullScreen, glutPopWindow,
    glutPositionWindow, glutPostRedisplay, glutPostWindowRedisplay, glutPushWindow, glutReshapeWindow,
    glutSetCursor, glutSetIconTitle, glutSetWindow, glutSetWindowData, glutSetWindowTitle, glutShowWindow,
    glutWarpPointer,
)

HAVE_FREEGLUT = True

__all__ = [
    "GLDEBUGPROC", "GLDEBUGPROCAMD", "GLDEBUGPROCARB", "GLDEBUGPROCKHR", "GLUT_3_2_CORE_PROFILE",
    "GLUT_ACCUM", "GLUT_ACTION_CONTINUE_EXECUTION", "GLUT_ACTION_EXIT", "GLUT_ACTION_GLUTMAINLOOP_RETURNS",
    "GLUT_ACTION_ON_WINDOW_CLOSE", "GLUT_ACTIVE_ALT", "GLUT_ACTIVE_CTRL", "GLUT_ACTIVE_SHIFT",
    "GLUT_ACTIVE_SUPER", "GLUT_ALLOW_DIRECT_CONTEXT", "GLUT_ALPHA", "GLUT_API_VERSION", "GLUT_AUX",
    "GLUT_AUX1", "GLUT_AUX2", "GLUT_AUX3", "GLUT_AUX4", "GLUT_BITMAP_8_BY_13", "GLUT_BITMAP_9_BY_15",
    "GLUT_BITMAP_HELVETICA_10", "GLUT_BITMAP_HELVETICA_12", "GLUT_BITMAP_HELVETICA_18",
    "GLUT_BITMAP_TIMES_ROMAN_10", "GLUT_BITMAP_TIMES_ROMAN_24", "GLUT_BLUE", "GLUT_BORDERLESS",
    "GLUT_CAPTIONLESS", "GLUT_COMPATIBILITY_PROFILE", "GLUT_CORE_PROFILE", "GLUT_CREATE_NEW_CONTEXT",
    "GLUT_CURSOR_BOTTOM_LEFT_CORNER", "GLUT_CURSOR_BOTTOM_RIGHT_CORNER", "GLUT_CURSOR_BOTTOM_SIDE",
    "GLUT_CURSOR_CROSSHAIR", "GLUT_CURSOR_CYCLE", "GLUT_CURSOR_DESTROY", "GLUT_CURSOR_FULL_CROSSHAIR",
    "GLUT_CURSOR_HELP", "GLUT_CURSOR_INFO", "GLUT_CURSOR_INHERIT", "GLUT_CURSOR_LEFT_ARROW",
    "GLUT_CURSOR_LEFT_RIGHT", "GLUT_CURSOR_LEFT_SIDE", "GLUT_CURSOR_NONE", "GLUT_CURSOR_RIGHT_ARROW",
    "GLUT_CURSOR_RIGHT_SIDE", "GLUT_CURSOR_SPRAY", "GLUT_CURSOR_TEXT", "GLUT_CURSOR_TOP_LEFT_CORNER",
    "GLUT_CURSOR_TOP_RIGHT_CORNER", "GLUT_CURSOR_TOP_SIDE", "GLUT_CURSOR_UP_DOWN", "GLUT_CURSOR_WAIT",
    "GLUT_DEBUG", "GLUT_DEPTH", "GLUT_DEVICE_IGNORE_KEY_REPEAT", "GLUT_DEVICE_KEY_REPEAT",
    "GLUT_DIRECT_RENDERING", "GLUT_DISPLAY_MODE_POSSIBLE", "GLUT_DOUBLE", "GLUT_DOWN", "GLUT_ELAPSED_TIME",
    "GLUT_ENTERED", "GLUT_FORCE_DIRECT_CONTEXT", "GLUT_FORCE_INDIRECT_CONTEXT", "GLUT_FORWARD_COMPATIBLE",
    "GLUT_FULLY_COVERED", "GLUT_FULLY_RETAINED", "GLUT_FULL_SCREEN", "GLUT_GAME_MODE_ACTIVE",
    "GLUT_GAME_MODE_DISPLAY_CHANGED", "GLUT_GAME_MODE_HEIGHT", "GLUT_GAME_MODE_PIXEL_DEPTH",
    "GLUT_GAME_MODE_POSSIBLE", "GLUT_GAME_MODE_REFRESH_RATE", "GLUT_GAME_MODE_WIDTH", "GLUT_GREEN",
    "GLUT_HAS_DIAL_AND_BUTTON_BOX", "GLUT_HAS_JOYSTICK", "GLUT_HAS_KEYBOARD", "GLUT_HAS_MOUSE",
    "GLUT_HAS_OVERLAY", "GLUT_HAS_SPACEBALL", "GLUT_HAS_TABLET", "GLUT_HIDDEN", "GLUT_INDEX",
    "GLUT_INIT_DISPLAY_MODE", "GLUT_INIT_FLAGS", "GLUT_INIT_MAJOR_VERSION", "GLUT_INIT_MINOR_VERSION",
    "GLUT_INIT_PROFILE", "GLUT_INIT_STATE", "GLUT_INIT_WINDOW_HEIGHT", "GLUT_INIT_WINDOW_WIDTH",
    "GLUT_INIT_WINDOW_X", "GLUT_INIT_WINDOW_Y", "GLUT_JOYSTICK_AXES", "GLUT_JOYSTICK_BUTTONS",
    "GLUT_JOYSTICK_BUTTON_A", "GLUT_JOYSTICK_BUTTON_B", "GLUT_JOYSTICK_BUTTON_C", "GLUT_JOYSTICK_BUTTON_D",
    "GLUT_JOYSTICK_POLL_RATE", "GLUT_KEY_ALT_L", "GLUT_KEY_ALT_R", "GLUT_KEY_BEGIN", "GLUT_KEY_CTRL_L",
    "GLUT_KEY_CTRL_R", "GLUT_KEY_DELETE", "GLUT_KEY_DOWN", "GLUT_KEY_END", "GLUT_KEY_F1", "GLUT_KEY_F2",
    "GLUT_KEY_F3", "GLUT_KEY_F4", "GLUT_KEY_F5", "GLUT_KEY_F6", "GLUT_KEY_F7", "GLUT_KEY_F8", "GLUT_KEY_F9",
    "GLUT_KEY_F10", "GLUT_KEY_F11", "GLUT_KEY_F12", "GLUT_KEY_HOME", "GLUT_KEY_INSERT", "GLUT_KEY_LEFT",
    "GLUT_KEY_NUM_LOCK", "GLUT_KEY_PAGE_DOWN", "GLUT_KEY_PAGE_UP", "GLUT_KEY_REPEAT_DEFAULT",
    "GLUT_KEY_REPEAT_OFF", "GLUT_KEY_REPEAT_ON", "GLUT_KEY_RIGHT", "GLUT_KEY_SHIFT_L", "GLUT_KEY_SHIFT_R",
    "GLUT_KEY_UP", "GLUT_LAYER_IN_USE", "GLUT_LEFT", "GLUT_LEFT_BUTTON", "GLUT_LUMINANCE", "GLUT_MENU_IN_USE",
    "GLUT_MENU_NOT_IN_USE", "GLUT_MENU_NUM_ITEMS", "GLUT_MIDDLE_BUTTON", "GLUT_MULTISAMPLE", "GLUT_NORMAL",
    "GLUT_NORMAL_DAMAGED", "GLUT_NOT_VISIBLE", "GLUT_NO_RECOVERY", "GLUT_NUM_BUTTON_BOX_BUTTONS",
    "GLUT_NUM_DIALS", "GLUT_NUM_MOUSE_BUTTONS", "GLUT_NUM_SPACEBALL_BUTTONS", "GLUT_NUM_TABLET_BUTTONS",
    "GLUT_OVERLAY", "GLUT_OVERLAY_DAMAGED", "GLUT_OVERLAY_POSSIBLE", "GLUT_OWNS_JOYSTICK",
    "GLUT_PARTIALLY_RETAINED", "GLUT_RED", "GLUT_RENDERING_CONTEXT", "GLUT_RGB", "GLUT_RGBA",
    "GLUT_RIGHT_BUTTON", "GLUT_SCREEN_HEIGHT", "GLUT_SCREEN_HEIGHT_MM", "GLUT_SCREEN_WIDTH",
    "GLUT_SCREEN_WIDTH_MM", "GLUT_SINGLE", "GLUT_SRGB", "GLUT_STENCIL", "GLUT_STEREO",
    "GLUT_STROKE_MONO_ROMAN", "GLUT_STROKE_ROMAN", "GLUT_TRANSPARENT_INDEX", "GLUT_TRY_DIRECT_CONTEXT",
    "GLUT_UP", "GLUT_USE_CURRENT_CONTEXT", "GLUT_VERSION", "GLUT_VIDEO_RESIZE_HEIGHT",
    "GLUT_VIDEO_RESIZE_HEIGHT_DELTA", "GLUT_VIDEO_RESIZE_IN_USE", "GLUT_VIDEO_RESIZE_POSSIBLE",
    "GLUT_VIDEO_RESIZE_WIDTH", "GLUT_VIDEO_RESIZE_WIDTH_DELTA", "GLUT_VIDEO_RESIZE_X",
    "GLUT_VIDEO_RESIZE_X_DELTA", "GLUT_VIDEO_RESIZE_Y", "GLUT_VIDEO_RESIZE_Y_DELTA", "GLUT_VISIBLE",
    "GLUT_WINDOW_ACCUM_ALPHA_SIZE", "GLUT_WINDOW_ACCUM_BLUE_SIZE", "GLUT_WINDOW_ACCUM_GREEN_SIZE",
    "GLUT_WINDOW_ACCUM_RED_SIZE", "GLUT_WINDOW_ALPHA_SIZE", "GLUT_WINDOW_BLUE_SIZE",
    "GLUT_WINDOW_BORDER_WIDTH", "GLUT_WINDOW_BUFFER_SIZE", "GLUT_WINDOW_COLORMAP_SIZE", "GLUT_WINDOW_CURSOR",
    "GLUT_WINDOW_DEPTH_SIZE", "GLUT_WINDOW_DOUBLEBUFFER", "GLUT_WINDOW_FORMAT_ID", "GLUT_WINDOW_GREEN_SIZE",
    "GLUT_WINDOW_HEADER_HEIGHT", "GLUT_WINDOW_HEIGHT", "GLUT_WINDOW_NUM_CHILDREN", "GLUT_WINDOW_NUM_SAMPLES",
    "GLUT_WINDOW_PARENT", "GLUT_WINDOW_RED_SIZE", "GLUT_WINDOW_RGBA", "GLUT_WINDOW_STENCIL_SIZE",
    "GLUT_WINDOW_STEREO", "GLUT_WINDOW_WIDTH", "GLUT_WINDOW_X", "GLUT_WINDOW_Y", "GLUT_XLIB_IMPLEMENTATION",
    "GL_BYTE", "GL_CHAR", "GL_DOUBLE", "GL_FALSE", "GL_FIXED", "GL_FLOAT", "GL_HALF_FLOAT", "GL_HALF_NV",
    "GL_INT", "GL_SHORT", "GL_TRUE", "GL_UNSIGNED_BYTE", "GL_UNSIGNED_INT", "GL_UNSIGNED_INT64",
    "GL_UNSIGNED_SHORT", "GL_VOID_P", "HAVE_FREEGLUT", "Constant", "GLbitfield", "GLboolean", "GLbyte",
    "GLchar", "GLcharARB", "GLclampd", "GLclampf", "GLclampx", "GLdouble", "GLdouble_2", "GLdouble_3",
    "GLdouble_4", "GLeglImageOES", "GLenum", "GLfixed", "GLfloat", "GLfloat_2", "GLfloat_3", "GLfloat_4",
    "GLhalfARB", "GLhalfNV", "GLhandle", "GLhandleARB", "GLint", "GLint64", "GLint64EXT", "GLintptr",
    "GLintptrARB", "GLshort", "GLsizei", "GLsizeiptr", "GLsizeiptrARB", "GLsync", "GLubyte", "GLubyte_3",
    "GLuint", "GLuint64", "GLuint64EXT", "GLulong", "GLushort", "GLvdpauSurfaceNV", "GLvoid", "GLvoidp",
    "ctypes", "fgDeinitialize", "glutAddMenuEntry", "glutAddSubMenu", "glutAttachMenu", "glutBitmapCharacter",
    "glutBitmapHeight", "glutBitmapLength", "glutBitmapString", "glutBitmapWidth", "glutButtonBoxFunc",
    "glutChangeToMenuEntry", "glutChangeToSubMenu", "glutCheckLoop", "glutCloseFunc", "glutCopyColormap",
    "glutCreateMenu", "glutCreateSubWindow", "glutCreateWindow", "glutDestroyMenu", "glutDestroyWindow",
    "glutDetachMenu", "glutDeviceGet", "glutDialsFunc", "glutDisplayFunc", "glutEnterGameMode",
    "glutEntryFunc", "glutEstablishOverlay", "glutExit", "glutExtensionSupported", "glutForceJoystickFunc",
    "glutFullScreen", "glutFullScreenToggle", "glutGameModeGet", "glutGameModeString", "glutGet",
    "glutGetColor", "glutGetMenu", "glutGetMenuData", "glutGetModeValues", "glutGetModifiers",
    "glutGetProcAddress", "glutGetWindow", "glutGetWindowData", "glutHideOverlay", "glutHideWindow",
    "glutIconifyWindow", "glutIdleFunc", "glutIgnoreKeyRepeat", "glutInit", "glutInitContextFlags",
    "glutInitContextProfile", "glutInitContextVersion", "glutInitDisplayMode", "glutInitDisplayString",
    "glutInitErrorFunc", "glutInitWarningFunc", "glutInitWindowPosition", "glutInitWindowSize",
    "glutJoystickFunc", "glutKeyboardFunc", "glutKeyboardUpFunc", "glutLayerGet", "glutLeaveFullScreen",
    "glutLeaveGameMode", "glutLeaveMainLoop", "glutMainLoop", "glutMainLoopEvent", "glutMenuDestroyFunc",
    "glutMenuStateFunc", "glutMenuStatusFunc", "glutMotionFunc", "glutMouseFunc", "glutMouseWheelFunc",
    "glutOverlayDisplayFunc", "glutPassiveMotionFunc", "glutPopWindow", "glutPositionFunc",
    "glutPositionWindow", "glutPostOverlayRedisplay", "glutPostRedisplay", "glutPostWindowOverlayRedisplay",
    "glutPostWindowRedisplay", "glutPushWindow", "glutRemoveMenuItem", "glutRemoveOverlay",
    "glutReportErrors", "glutReshapeFunc", "glutReshapeWindow", "glutSetColor", "glutSetCursor",
    "glutSetIconTitle", "glutSetKeyRepeat", "glutSetMenu", "glutSetMenuData", "glutSetOption",
    "glutSetWindow", "glutSetWindowData", "glutSetWindowTitle", "glutSetupVideoResizing", "glutShowOverlay",
    "glutShowWindow", "glutSolidCone", "glutSolidCube", "glutSolidCylinder", "glutSolidDodecahedron",
    "glutSolidIcosahedron", "glutSolidOctahedron", "glutSolidRhombicDodecahedron",
    "glutSolidSierpinskiSponge", "glutSolidSphere", "glutSolidTeacup", "glutSolidTeapot", "glutSolidTeaspoon",
    "glutSolidTetrahedron", "glutSolidTorus", "glutSpaceballButtonFunc", "glutSpaceballMotionFunc",
    "glutSpaceballRotateFunc", "glutSpecialFunc", "glutSpecialUpFunc", "glutStopVideoResizing",
    "glutStrokeCharacter", "glutStrokeHeight", "glutStrokeLength", "glutStrokeLengthf", "glutStrokeString",
    "glutStrokeWidth", "glutStrokeWidthf", "glutSwapBuffers", "glutTabletButtonFunc", "glutTabletMotionFunc",
    "glutTimerFunc", "glutUseLayer", "glutVideoPan", "glutVideoResize", "glutVideoResizeGet",
    "glutVisibilityFunc", "glutWMCloseFunc", "glutWarpPointer", "glutWindowStatusFunc", "glutWireCone",
    "glutWireCube", "glutWireCylinder", "glutWireDodecahedron", "glutWireIcosahedron", "glutWireOctahedron",
    "glutWireRhombicDodecahedron", "glutWireSierpinskiSponge", "glutWireSphere", "glutWireTeacup",
    "glutWireTeapot", "glutWireTeaspoon", "glutWireTetrahedron", "glutWireTorus", "os", "sys", "traceback",
]

startup.arm_if_asked()
