// A triangle's edges by their angles; its inside finer, since there the blend is less even.
layout(vertices = 3) out;
patch out vec3 domeAngles;
patch out vec3 domeDistances;

void subdivide() {
    Edges triangle = edgesOf(gl_in[0].gl_Position, gl_in[1].gl_Position, gl_in[2].gl_Position);
    domeAngles = triangle.angles;
    domeDistances = triangle.distances;
    gl_TessLevelOuter[0] = triangle.pieces.x;
    gl_TessLevelOuter[1] = triangle.pieces.y;
    gl_TessLevelOuter[2] = triangle.pieces.z;
    gl_TessLevelInner[0] = ceil(1.2 * max(max(triangle.pieces.x, triangle.pieces.y), triangle.pieces.z));
}
