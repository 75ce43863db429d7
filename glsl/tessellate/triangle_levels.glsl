// A triangle's pieces for the tessellator; its inside finer, since there the blend is less even.
patch out vec3 domeAngles;
patch out vec3 domeDistances;

void setLevels(Edges triangle) {
    domeAngles = triangle.angles;
    domeDistances = triangle.distances;
    gl_TessLevelOuter[0] = triangle.pieces.x;
    gl_TessLevelOuter[1] = triangle.pieces.y;
    gl_TessLevelOuter[2] = triangle.pieces.z;
    gl_TessLevelInner[0] = ceil(1.2 * max(max(triangle.pieces.x, triangle.pieces.y), triangle.pieces.z));
}
