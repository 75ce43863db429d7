// The most pieces of an edge of the patch.
float pieces() {
    vec4 outer = vec4(gl_TessLevelOuter[0], gl_TessLevelOuter[1], gl_TessLevelOuter[2], gl_TessLevelOuter[3]);
    return max(max(outer.x, outer.y), max(outer.z, outer.w));
}
