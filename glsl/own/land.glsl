// A program's own gl_Position goes onto the dome. domeMode: 0 leaves it as it is, 1 puts it on the dome at its
// true angle, 2 on the panel. domeFromClip takes its clip coordinates to the dome's eye space or to the panel.
uniform float domeMode;
uniform mat4 domeFromClip;

vec4 domePlace(vec4 clip) {
    vec4 place = domeFromClip * clip;
    place.w = max(place.w, 0.0); // beyond infinity, by rounding: at infinity
    return place;
}
