// One colour where the main view's edges allow it: domeEdges = (left, right, bottom, top), domeSides = 1 for
// each of them that cuts.
uniform vec4 domeEdges;
uniform vec4 domeSides;
uniform vec4 domeColor;
varying vec3 seen;

void main() {
    vec4 inside = vec4(seen.x - domeEdges.x * seen.z, domeEdges.y * seen.z - seen.x,
                       seen.y - domeEdges.z * seen.z, domeEdges.w * seen.z - seen.y);
    if (any(lessThan(inside * domeSides, vec4(0.0))))
        discard;
    gl_FragColor = domeColor;
}
