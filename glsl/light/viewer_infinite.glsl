// The specular highlight's viewer, infinitely far along +z (GL_LIGHT_MODEL_LOCAL_VIEWER off).
vec3 toViewer(vec4 eye) {
    return vec3(0.0, 0.0, 1.0);
}
