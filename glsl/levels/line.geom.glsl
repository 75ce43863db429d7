// The pieces of the line.
float pieces() {
    return edgesOf(gl_in[0].gl_Position, gl_in[1].gl_Position).pieces;
}
