// The dome's picture from its cube faces: each pixel's radius gives its angle from the axis by a table, and the
// direction the face that looks most nearly there.
const int MOST = 6;
uniform sampler2D faces; // all of them, in one picture
uniform sampler2D depths; // of the faces
uniform sampler2D angles; // (n, 1): radians, at even steps of the radius from 0 to the rim
uniform vec4 disc; // centre x, centre y, radius and rim of the picture, pixels
uniform int count;
uniform mat3 axes[MOST]; // a direction into each face's own right, up and ahead
uniform vec4 places[MOST]; // where each face's middle lies in faces, and half its size, 0 to 1
uniform vec2 planar; // the faces' depth * w = planar.x * w + planar.y
uniform vec2 radial; // the same by distance, for the window
uniform vec2 range; // the depth range, near and far
uniform bool deep; // depth is wanted as well
out vec4 color;

float angleAt(float radius) {
    float place = radius / disc.w * float(textureSize(angles, 0).x - 1);
    int below = int(place);
    float a = texelFetch(angles, ivec2(below, 0), 0).x;
    float b = texelFetch(angles, ivec2(min(below + 1, textureSize(angles, 0).x - 1), 0), 0).x;
    return mix(a, b, place - float(below));
}

void main() {
    vec2 away = gl_FragCoord.xy - disc.xy;
    float radius = length(away);
    if (radius > disc.w)
        discard;
    float phi = angleAt(radius);
    vec3 seen = seenAlong(vec3(radius > 0.0 ? away * (sin(phi) / radius) : vec2(0.0), -cos(phi)));
    vec3 best = axes[0] * seen;
    vec4 place = places[0];
    for (int i = 1; i < count; i++) {
        vec3 q = axes[i] * seen;
        if (q.z > best.z) {
            best = q;
            place = places[i];
        }
    }
    vec2 found = place.xy + place.zw * best.xy / best.z;
    color = texture(faces, found);
    gl_FragDepth = 1.0;
    if (deep) {
        float held = texture(depths, found).x;
        float ahead = planar.y / (2.0 * (held - range.x) / (range.y - range.x) - 1.0 - planar.x);
        float depth = radial.x + radial.y * best.z / length(seen) / ahead;
        bool drawn = held < max(range.x, range.y) && planar.y != 0.0;
        gl_FragDepth = drawn ? range.x + (range.y - range.x) * (depth + 1.0) / 2.0 : held;
    }
}
