// What travels down the pipeline is the clip coordinate; its place on the panel follows.
uniform mat4 domeView;

vec4 placeOf(vec4 position) {
    return domeView * position;
}
