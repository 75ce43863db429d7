// Bailey, Clothier, Gebbie 2006, as published: the disc at the vertex's own z, through
// glOrtho(-1, 1, -1, 1, 0, 1000); w stays 1.
vec4 bent(vec4 p) {
    return vec4(landed(p.xyz), -p.z / 500.0 - 1.0, 1.0);
}
