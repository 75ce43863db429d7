// A parallelogram's edges by their angles; its inside by its own, both ways.
layout(vertices = 4) out;
patch out vec4 domeAngles;
patch out vec4 domeDistances;

void subdivide() {
    Edges quad = edgesOf(gl_in[0].gl_Position, gl_in[1].gl_Position, gl_in[2].gl_Position, gl_in[3].gl_Position);
    domeAngles = quad.angles;
    domeDistances = quad.distances;
    gl_TessLevelOuter[0] = quad.pieces.w;
    gl_TessLevelOuter[1] = quad.pieces.x;
    gl_TessLevelOuter[2] = quad.pieces.y;
    gl_TessLevelOuter[3] = quad.pieces.z;
    gl_TessLevelInner[0] = quad.inside.x;
    gl_TessLevelInner[1] = quad.inside.y;
}
