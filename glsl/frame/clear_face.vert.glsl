// Two triangles over a cube face, by number() alone. domeSeen takes a direction on the dome to x, y and w in
// the program's main view; domeFace to the face's own axes; domeDepth: the depth to write, -1 to 1.
uniform mat4 domeSeen;
uniform mat4 domeFace;
uniform float domeDepth;
varying vec3 seen;

void main() {
    int corner = number() < 3 ? number() : 6 - number();
    vec2 place = vec2(corner % 2, corner / 2) * 2.0 - 1.0;
    mat3 axes = transpose(mat3(domeFace)); // right and up, each divided by what the face reaches, and ahead
    vec3 right = axes[0] / dot(axes[0], axes[0]), up = axes[1] / dot(axes[1], axes[1]);
    seen = (domeSeen * vec4(place.x * right + place.y * up + axes[2], 0.0)).xyw;
    gl_Position = vec4(place, domeDepth, 1.0);
}
