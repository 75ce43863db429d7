// Bailey, Clothier, Gebbie 2006, as published: the disc at the vertex's own z, through
// glOrtho(-1, 1, -1, 1, 0, 1000); w stays 1.
vec4 bent(vec4 p) {
    float rxy = length(p.xy);
    if (rxy != 0.0)
        p.xy *= lensRadius(atan(rxy, -p.z)) / rxy;
    return vec4(p.xy, -p.z / 500.0 - 1.0, 1.0);
}
