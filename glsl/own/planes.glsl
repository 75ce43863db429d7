// The program's first four clip planes: its clip distances replace them. domePlanes: 1 where any is enabled.
uniform float domePlanes;

vec4 domePlanesOf(vec4 eye) {
    return vec4(dot(eye, gl_ClipPlane[0]), dot(eye, gl_ClipPlane[1]), dot(eye, gl_ClipPlane[2]),
                dot(eye, gl_ClipPlane[3]));
}
