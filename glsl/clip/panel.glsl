// A draw ends where the monitor's viewport and scissor end: domeEdges = (left, right, bottom, top) in
// normalised device coordinates.
uniform vec4 domeEdges = vec4(-1.0, 1.0, -1.0, 1.0);

vec4 insideViewport(vec4 clip) {
    return vec4(clip.x - domeEdges.x * clip.w, domeEdges.y * clip.w - clip.x,
                clip.y - domeEdges.z * clip.w, domeEdges.w * clip.w - clip.y);
}
