// A polar grid over the whole disc, by gl_VertexID alone: 64 rings of 128 cells of two triangles.
// domeSeen takes a direction in the dome's space to x, y and w in the program's main view; domeHalf: half the field of
// view in radians; domeDepth: the depth to write, -1 to 1.
uniform mat4 domeSeen;
uniform float domeHalf;
uniform float domeDepth;
varying vec3 seen;

void main() {
    int cell = gl_VertexID / 6, corner = gl_VertexID % 6;
    int outward = corner == 1 || corner == 2 || corner == 4 ? 1 : 0;
    int onward = corner == 2 || corner == 4 || corner == 5 ? 1 : 0;
    float phi = domeHalf * float(cell / 128 + outward) / 64.0;
    float theta = 6.28318530718 * float((cell % 128 + onward) % 128) / 128.0;
    vec2 away = vec2(cos(theta), sin(theta));
    seen = (domeSeen * vec4(seenAlong(vec3(sin(phi) * away, -cos(phi))), 0.0)).xyw;
    gl_Position = onSurface(vec4(lensRadius(phi) * away, domeDepth, 1.0));
}
