// Viewer and projector are at the dome's centre: what a ray carries is seen along it.
vec3 seenAlong(vec3 ray) {
    return ray;
}
