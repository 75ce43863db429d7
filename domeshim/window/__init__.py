"""7 of 7: where the picture appears: a window (glfw) or an off-screen surface (EGL), the frame, the clock."""
