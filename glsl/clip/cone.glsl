// Cone around straight behind that is left out: negative inside.
// domeRim = (cos, sin) of the cone's half angle. It is |p| sin(angle from straight behind - half angle), which
// stays exact for the narrowest of cones.
uniform vec2 domeRim;

float inFront(vec4 p) {
    float largest = max(abs(p.x), abs(p.y));
    float rxy = largest > 0.0 ? largest * length(p.xy / largest) : 0.0; // no square may overflow or vanish
    return domeRim.x * rxy - domeRim.y * (p.w < 0.0 ? -p.z : p.z);
}
