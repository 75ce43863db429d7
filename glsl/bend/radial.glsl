// Where a direction lands on the disc: out from its middle, as far as the lens says.
vec2 landed(vec3 d) {
    float rxy = length(d.xy);
    return rxy > 0.0 ? d.xy * (lensRadius(atan(rxy, -d.z)) / rxy) : vec2(0.0);
}
