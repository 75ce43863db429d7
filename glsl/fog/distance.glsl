// Fog by distance from the viewer.
float fogCoordinate(vec4 eye) {
    return length(eye.xyz / eye.w);
}
