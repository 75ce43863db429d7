// Where on the line a vertex of the tessellator's lies.
layout(isolines, equal_spacing) in;
patch in float domeAngle;
patch in vec2 domeDistances;

vec2 weights() {
    return evenOnEdge(vec2(1.0 - gl_TessCoord.x, gl_TessCoord.x), domeAngle, domeDistances);
}
