// The program's own clip plane, in its own eye space: on OpenGL 2 gl_ClipPlane holds the dome's meanwhile.
uniform vec4 domePlanes[8];

float abovePlane(int plane, vec4 eye) {
    return dot(eye, domePlanes[plane]);
}
