// A point of the panel goes onto the disc; its depth stays the monitor's.
vec4 bent(vec4 p, float depth) {
    float rxy = length(p.xy);
    float phi = atan(rxy, -p.z);
    vec2 disc = rxy > 0.0 ? p.xy * (lensRadius(phi) / rxy) : vec2(0.0);
    float r = length(p.xyz);
    return vec4(disc * r, depth * r, r);
}
