// GL_RESCALE_NORMAL: undo the modelview's uniform scale.
vec3 eyeNormal() {
    return gl_NormalScale * (gl_NormalMatrix * gl_Normal);
}
