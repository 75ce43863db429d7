// The most pieces of an edge of the patch.
float pieces() {
    return max(max(gl_TessLevelOuter[0], gl_TessLevelOuter[1]), gl_TessLevelOuter[2]);
}
