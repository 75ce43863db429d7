// Where in a triangle a point lies: even in angle on each edge, a blend of the three inside. s: its three
// shares; angles: of the edge opposite to each corner; distances: of the corners from the eye.
vec3 evenWeights(vec3 s, vec3 angles, vec3 distances) {
    if (s.z <= 0.0)
        return vec3(evenOnEdge(s.xy, angles.z, distances.xy), 0.0);
    if (s.x <= 0.0)
        return vec3(0.0, evenOnEdge(s.yz, angles.x, distances.yz));
    if (s.y <= 0.0)
        return vec3(evenOnEdge(s.xz, angles.y, distances.xz), 0.0).xzy;
    vec3 e = vec3(s.y * s.z, s.z * s.x, s.x * s.y);
    float a = dot(e, angles) / (e.x + e.y + e.z);
    vec3 even = a > 1e-3 ? sin(s * a) : s;
    float nearest = min(min(distances.x, distances.y), distances.z);
    vec3 b = even * (nearest / distances);
    return b / (b.x + b.y + b.z);
}
