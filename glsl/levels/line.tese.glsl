// The pieces of the line.
float pieces() {
    return gl_TessLevelOuter[1];
}
