// The specular highlight's viewer at the eye (GL_LIGHT_MODEL_LOCAL_VIEWER on).
vec3 toViewer(vec4 eye) {
    return -normalize(eye.xyz);
}
