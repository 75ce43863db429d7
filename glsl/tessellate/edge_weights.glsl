// Where on an edge or a line a point lies: even in angle. s: its two shares; distances: of the ends from the eye.
// Nothing but the two ends comes in: whatever shares the edge finds the same, bit by bit.
vec2 evenOnEdge(vec2 s, float angle, vec2 distances) {
    if (s.x <= 0.0 || s.y <= 0.0)
        return s; // an end
    vec2 even = angle > 1e-3 ? sin(s * angle) : s;
    precise vec2 b = even * (min(distances.x, distances.y) / distances);
    precise float total = b.x + b.y;
    return b / total;
}
