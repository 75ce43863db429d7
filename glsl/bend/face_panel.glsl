// A point of the panel goes onto the face; its depth stays the monitor's.
vec4 bent(vec4 p, float depth) {
    vec3 q = onFace(p);
    return vec4(q.xy, depth * q.z, q.z);
}
