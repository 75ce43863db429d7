// The program's first clip planes: clip distances take their place.
vec3 domePlanesOf(vec4 eye) {
    return vec3(dot(eye, gl_ClipPlane[0]), dot(eye, gl_ClipPlane[1]), dot(eye, gl_ClipPlane[2]));
}
