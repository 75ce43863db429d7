// A parallelogram's pieces for the tessellator; its inside by its own, both ways.
patch out vec4 domeAngles;
patch out vec4 domeDistances;

void setLevels(Edges quad) {
    domeAngles = quad.angles;
    domeDistances = quad.distances;
    gl_TessLevelOuter[0] = quad.pieces.w;
    gl_TessLevelOuter[1] = quad.pieces.x;
    gl_TessLevelOuter[2] = quad.pieces.y;
    gl_TessLevelOuter[3] = quad.pieces.z;
    gl_TessLevelInner[0] = quad.inside.x;
    gl_TessLevelInner[1] = quad.inside.y;
}
