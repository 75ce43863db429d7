// What travels down the pipeline is the point in the dome's eye space.
vec4 placeOf(vec4 position) {
    return position;
}
