// The square of the disc goes to four corners: domeKeystone, a projective map of its homogeneous places. Depth over w
// stays, so what is nearer stays nearer.
uniform mat3 domeKeystone;

vec4 onSurface(vec4 p) {
    vec3 q = domeKeystone * p.xyw;
    return vec4(q.xy, p.w > 0.0 ? p.z * q.z / p.w : p.z, q.z);
}
