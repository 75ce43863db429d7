// Coordinates of GL_SPHERE_MAP.
vec4 sphereMap(vec4 eye, vec3 normal) {
    vec3 r = reflect(normalize(eye.xyz), normal);
    float m = 2.0 * sqrt(r.x * r.x + r.y * r.y + (r.z + 1.0) * (r.z + 1.0));
    return vec4(r.xy / m + 0.5, 0.0, 1.0);
}
