// The panel ends where the monitor's viewport ends.
vec4 insideViewport(vec4 clip) {
    return vec4(clip.w + clip.x, clip.w - clip.x, clip.w + clip.y, clip.w - clip.y);
}
