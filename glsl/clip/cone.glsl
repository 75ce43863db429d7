// Cone around the anti-axis that a lens of more than 180 degrees leaves out: negative inside.
// domeRim = -cos(fov / 2), or of an angle a little short of straight behind.
uniform float domeRim;

float inFront(vec4 p) {
    return (p.w < 0.0 ? p.z : -p.z) + domeRim * length(p.xyz);
}
