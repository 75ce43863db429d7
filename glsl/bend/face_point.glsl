// A homogeneous point goes onto the face by a plain perspective: domeDepth = (a, b), depth * w = a * w + b.
uniform vec2 domeDepth;

vec4 bent(vec4 p) {
    p = p.w < 0.0 ? -p : p;
    vec3 q = onFace(p);
    return vec4(q.xy, domeDepth.x * q.z + domeDepth.y * p.w, q.z);
}
