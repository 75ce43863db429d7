// Coordinates of GL_REFLECTION_MAP.
vec4 reflectionMap(vec4 eye, vec3 normal) {
    return vec4(reflect(normalize(eye.xyz), normal), 1.0);
}
