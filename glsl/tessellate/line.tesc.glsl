// A line by its angle.
layout(vertices = 2) out;

void subdivide() {
    setLevels(edgesOf(gl_in[0].gl_Position, gl_in[1].gl_Position));
}
