// Where in a parallelogram a point lies: even in angle on each edge, and both ways inside. s: how far from the
// first corner to the second, and to the fourth; angles: of the edge from each corner to the next; distances:
// of the corners from the eye.
vec4 evenWeights(vec2 s, vec4 angles, vec4 distances) {
    vec2 t = 1.0 - s;
    vec2 x = vec2(t.x, s.x), y = vec2(t.y, s.y);
    if (s.y <= 0.0)
        return vec4(evenOnEdge(x, angles.x, distances.xy), 0.0, 0.0);
    if (s.y >= 1.0)
        return vec4(0.0, 0.0, evenOnEdge(x, angles.z, distances.wz).yx);
    if (s.x >= 1.0)
        return vec4(0.0, evenOnEdge(y, angles.y, distances.yz), 0.0);
    if (s.x <= 0.0)
        return vec4(evenOnEdge(y, angles.w, distances.xw), 0.0, 0.0).xzwy;
    float across = mix(angles.x, angles.z, s.y), up = mix(angles.w, angles.y, s.x);
    x = across > 1e-3 ? sin(x * across) : x;
    y = up > 1e-3 ? sin(y * up) : y;
    float nearest = min(min(distances.x, distances.y), min(distances.z, distances.w));
    vec4 b = x.xyyx * y.xxyy * (nearest / distances);
    return b / (b.x + b.y + b.z + b.w);
}
