// A line's pieces for the tessellator.
patch out float domeAngle;
patch out vec2 domeDistances;

void setLevels(Edges line) {
    domeAngle = line.angle;
    domeDistances = line.distances;
    gl_TessLevelOuter[0] = line.pieces > 0.0 ? 1.0 : 0.0;
    gl_TessLevelOuter[1] = line.pieces;
}
