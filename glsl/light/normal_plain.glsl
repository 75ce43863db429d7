// The normal as the matrices leave it.
vec3 eyeNormal() {
    return gl_NormalMatrix * gl_Normal;
}
