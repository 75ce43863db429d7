// Where in the triangle a vertex of the tessellator's lies.
layout(triangles, equal_spacing, ccw) in;
patch in vec3 domeAngles;
patch in vec3 domeDistances;

vec3 weights() {
    return evenWeights(gl_TessCoord, domeAngles, domeDistances);
}
