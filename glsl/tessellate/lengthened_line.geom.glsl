// A line leaves as one strip of pieces even in angle; one shorter than a pixel is made as long as a pixel, for
// a driver that leaves out what lies between two pixels' borders.
layout(lines) in;
layout(line_strip, max_vertices = DOME_MOST_VERTICES) out;
uniform vec2 domeHalf; // of the viewport's sides, in pixels

void vertexAt(vec2 b);

void emitAt(vec2 b, vec2 moved) {
    vertexAt(b);
    gl_Position.xy += moved * gl_Position.w;
    EmitVertex();
}

// By how much each end is to move for a line a little over a pixel long.
vec2 missing(vec4 end0, vec4 end1) {
    vec2 along = (end1.xy / end1.w - end0.xy / end0.w) * domeHalf;
    float size = length(along);
    return size > 0.0 && size < 1.05 ? (0.5 * (1.05 / size - 1.0)) * along / domeHalf : vec2(0.0);
}

void main() {
    Edges line = edgesOf(gl_in[0].gl_Position, gl_in[1].gl_Position);
    int n = int(line.pieces);
    if (n == 0)
        return;
    vec2 moved = vec2(0.0);
    if (n == 1) {
        vertexAt(vec2(1.0, 0.0));
        vec4 end0 = gl_Position;
        vertexAt(vec2(0.0, 1.0));
        moved = missing(end0, gl_Position);
    }
    emitAt(vec2(1.0, 0.0), -moved);
    for (int k = 1; k < n; ++k)
        emitAt(evenOnEdge(vec2(n - k, k) / float(n), line.angle, line.distances), vec2(0.0));
    emitAt(vec2(0.0, 1.0), moved);
    EndPrimitive();
}
