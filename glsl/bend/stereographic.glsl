// Where a direction lands on the disc of a stereographic lens: the tangent of half its angle from the ray itself,
// for near straight behind the angle's own rounding would grow with the tangent.
vec2 landed(vec3 d) {
    float rxy = length(d.xy), r = length(d);
    if (rxy == 0.0)
        return vec2(0.0);
    float radius = domeLens.z * (d.z > 0.0 ? (r + d.z) / rxy : rxy / (r - d.z));
    return d.xy / rxy * (radius < 1.0 ? radius : lensRadius(atan(rxy, -d.z)));
}
