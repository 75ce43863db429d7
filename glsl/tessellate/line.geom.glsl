// A line leaves as one strip of pieces even in angle.
layout(lines) in;
layout(line_strip, max_vertices = DOME_MOST_VERTICES) out;

void vertexAt(vec2 b);

void main() {
    Edges line = edgesOf(gl_in[0].gl_Position, gl_in[1].gl_Position);
    int n = int(line.pieces);
    if (n == 0)
        return;
    for (int k = 0; k <= n; ++k)
        vertexAt(evenOnEdge(vec2(n - k, k) / float(n), line.angle, line.distances));
    EndPrimitive();
}
