// A line by its angle.
layout(vertices = 2) out;
patch out float domeAngle;
patch out vec2 domeDistances;

void subdivide() {
    Edges line = edgesOf(gl_in[0].gl_Position, gl_in[1].gl_Position);
    domeAngle = line.angle;
    domeDistances = line.distances;
    gl_TessLevelOuter[0] = line.pieces > 0.0 ? 1.0 : 0.0;
    gl_TessLevelOuter[1] = line.pieces;
}
