// Half space behind a dome of at most 180 degrees: negative there.
float inFront(vec4 p) {
    return p.w < 0.0 ? p.z : -p.z;
}
