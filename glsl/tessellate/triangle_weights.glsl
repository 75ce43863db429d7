// Where in a triangle a point lies: even in angle on each edge, a blend of the three inside. s: its three
// shares; angles: of the edge opposite to each corner; distances: of the corners from the eye.
// On an edge nothing but its own two ends comes in, and its neighbour finds the same, bit by bit.
vec3 evenWeights(vec3 s, vec3 angles, vec3 distances) {
    vec3 e = vec3(s.y * s.z, s.z * s.x, s.x * s.y);
    float sum = e.x + e.y + e.z;
    if (sum <= 0.0)
        return s; // a corner
    float a = dot(e, angles) / sum;
    vec3 even = a > 1e-3 ? sin(s * a) : s;
    vec3 counted = mix(distances, vec3(3e38), equal(s, vec3(0.0)));
    float nearest = min(min(counted.x, counted.y), counted.z);
    precise vec3 b = even * min(nearest / distances, vec3(1.0));
    precise float total = b.x + b.y + b.z;
    return b / total;
}
