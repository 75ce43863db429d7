// The vertex's number.
int number() {
    return gl_VertexID;
}
