// What an eye sees that stands beside the viewer's middle and turns with the direction looked at: it is moved to
// the right by domeEye along the horizontal across that direction, fully up to 60 degrees above and below the
// horizon, and from there on in proportion to the cosine of the height: not at all straight up and down.
uniform float domeEye;

vec4 beside(vec4 p) {
    p = p.w < 0.0 ? -p : p;
    float largest = max(max(abs(p.x), abs(p.y)), abs(p.z));
    vec3 d = largest > 0.0 ? p.xyz / largest : vec3(0.0, 0.0, -1.0);
    vec2 right = vec2(-d.z, d.x) / max(length(d.xz), 0.5 * length(d));
    return vec4(p.xyz - p.w * domeEye * vec3(right.x, 0.0, right.y), p.w);
}
