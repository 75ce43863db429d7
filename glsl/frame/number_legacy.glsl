// The vertex's number, which OpenGL 2 has to be given.
int number() {
    return int(gl_Vertex.x + 0.5);
}
