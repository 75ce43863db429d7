// Negative where the tilted dome does not reach.
float reach(vec4 p) {
    return inFront(tilted(p));
}
