// The program's own clip plane, in its own eye space.
float abovePlane(int plane, vec4 eye) {
    return dot(eye, gl_ClipPlane[plane]);
}
