// Where in the parallelogram a vertex of the tessellator's lies.
layout(quads, equal_spacing, ccw) in;
patch in vec4 domeAngles;
patch in vec4 domeDistances;

vec4 weights() {
    return evenWeights(gl_TessCoord.xy, domeAngles, domeDistances);
}
