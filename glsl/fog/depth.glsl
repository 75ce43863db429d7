// Fog by planar depth in the program's own eye space, as on the monitor.
float fogCoordinate(vec4 eye) {
    return abs(eye.z);
}
