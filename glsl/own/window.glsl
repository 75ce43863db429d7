// Where the monitor would show a fragment, in the program's window: what its own gl_FragCoord says there.
// domeClip: the clip coordinates that its vertex shader left; domeWindow: its viewport.
uniform float domeMode;
uniform vec4 domeWindow;

vec4 domeFragCoord() {
    if (domeMode < 0.5)
        return gl_FragCoord;
    vec3 seen = domeClip.xyz / domeClip.w;
    return vec4(domeWindow.xy + (0.5 * seen.xy + 0.5) * domeWindow.zw, 0.5 * seen.z + 0.5, 1.0 / domeClip.w);
}
