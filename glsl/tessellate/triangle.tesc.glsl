// A triangle's edges by their angles.
layout(vertices = 3) out;

void subdivide() {
    setLevels(edgesOf(gl_in[0].gl_Position, gl_in[1].gl_Position, gl_in[2].gl_Position));
}
