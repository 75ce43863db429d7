// Where in the triangle a vertex lies: even in angle on each edge, a blend of the three inside.
layout(triangles, equal_spacing, ccw) in;
patch in vec3 domeAngles;
patch in vec3 domeNearness;

vec3 weights() {
    vec3 s = gl_TessCoord;
    vec3 e = vec3(s.y * s.z, s.z * s.x, s.x * s.y);
    float sum = e.x + e.y + e.z;
    if (sum <= 0.0)
        return s; // a corner
    float a = dot(e, domeAngles) / sum;
    vec3 even = a > 1e-3 ? sin(s * a) : s;
    precise vec3 b = even * domeNearness;
    precise float total = b.x + b.y + b.z;
    return b / total;
}
