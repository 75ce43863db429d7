// A point of the panel goes into the picture; its depth stays the monitor's.
vec4 bent(vec4 p, float depth) {
    float r = length(p.xyz);
    return vec4(landed(p.xyz) * r, depth * r, r);
}
