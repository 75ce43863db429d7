// Drawn without the dome's perspective: where it stood in the monitor's window gives its direction.
// domeView takes clip coordinates to the flat panel at distance 1.
uniform mat4 domeView;

vec4 placed(vec4 eye) {
    return domeView * (gl_ProjectionMatrix * eye);
}
