// The viewer, the projector or both are off the dome's centre: what the seat sees in a direction d falls on the
// dome at q, |q| = 1, and the projector throws it towards q. The distance stays the eye's own.
// domeTurn takes eye space to the dome's; domeSeat and domeProjector are places in it, in the dome's radii.
uniform mat3 domeTurn;
uniform vec3 domeSeat;
uniform vec3 domeProjector;

vec4 aimed(vec4 p) {
    float side = p.w < 0.0 ? -1.0 : 1.0;
    float largest = max(max(abs(p.x), abs(p.y)), abs(p.z));
    vec3 d = largest > 0.0 ? domeTurn * (side / largest * p.xyz) : vec3(0.0, 0.0, -1.0);
    float size = length(d);
    d /= size;
    float along = dot(domeSeat, d);
    vec3 q = domeSeat + d * (sqrt(along * along + 1.0 - dot(domeSeat, domeSeat)) - along);
    return vec4(side * size * largest * normalize(q - domeProjector), p.w);
}
