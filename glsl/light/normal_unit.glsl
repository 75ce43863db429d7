// GL_NORMALIZE.
vec3 eyeNormal() {
    vec3 n = gl_NormalMatrix * gl_Normal;
    float size = length(n);
    return size > 0.0 ? n / size : n;
}
