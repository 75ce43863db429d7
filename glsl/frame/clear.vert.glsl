// A grid over the whole picture, by number() alone: 64 rows of 128 cells of two triangles.
// domeSeen takes a direction in the dome's space to x, y and w in the program's main view; domeDepth: the depth to
// write, -1 to 1.
uniform mat4 domeSeen;
uniform float domeDepth;
varying vec3 seen;

void main() {
    int cell = number() / 6, corner = number() - 6 * cell, row = cell / 128;
    int outward = corner == 1 || corner == 2 || corner == 4 ? 1 : 0;
    int onward = corner == 2 || corner == 4 || corner == 5 ? 1 : 0;
    vec2 place;
    vec3 ray = rayAt(vec2(float(row + outward) / 64.0, float(cell - 128 * row + onward) / 128.0), place);
    seen = (domeSeen * vec4(seenAlong(ray), 0.0)).xyw;
    gl_Position = onSurface(vec4(place, domeDepth, 1.0));
}
