// A homogeneous point goes into the picture, with w = distance, so that what is interpolated stays
// perspective-correct, and depth by distance: domeDepth = (a, b), depth * w = a * distance + b.
uniform vec2 domeDepth;

vec4 bent(vec4 p) {
    p = p.w < 0.0 ? -p : p;
    float largest = max(max(abs(p.x), abs(p.y)), abs(p.z));
    vec3 d = largest > 0.0 ? p.xyz / largest : vec3(0.0, 0.0, -1.0); // no square may overflow or vanish
    float r = largest * length(d);
    return vec4(landed(d) * r, domeDepth.x * r + domeDepth.y * p.w, r);
}
