// Negative where the dome does not reach.
float reach(vec4 p) {
    return inFront(p);
}
