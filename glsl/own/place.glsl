// What travels down the pipeline is the program's clip coordinate; its place in the dome's eye space follows.
vec4 placeOf(vec4 position) {
    return domePlace(position);
}
