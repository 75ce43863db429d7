// Negative where the turned dome does not reach.
float reach(vec4 p) {
    return inFront(aimed(p));
}
