// Wedge around the upright half plane behind, which a cylindrical screen leaves open: negative inside.
// domeRim = (cos, sin) of half the wedge's angle, at most 90 degrees.
uniform vec2 domeRim;

float inFront(vec4 p) {
    return domeRim.x * abs(p.x) - domeRim.y * (p.w < 0.0 ? -p.z : p.z);
}
