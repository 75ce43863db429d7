// Where on a line a point lies: even in angle. s: its two shares; distances: of the ends from the eye.
vec2 evenWeights(vec2 s, float angle, vec2 distances) {
    if (s.x <= 0.0 || s.y <= 0.0)
        return s; // an end
    vec2 even = angle > 1e-3 ? sin(s * angle) : s;
    precise vec2 b = even * (min(distances.x, distances.y) / distances);
    return b / (b.x + b.y);
}
