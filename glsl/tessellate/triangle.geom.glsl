// A triangle leaves as a grid of n rows, each a strip. On the triangle's edges the grid's vertices move to the
// nearest of that edge's own pieces, which its two ends alone decide: neighbours meet, and triangles between
// vertices that meet vanish.
layout(triangles) in;
layout(triangle_strip, max_vertices = DOME_MOST_VERTICES) out;

void vertexAt(vec3 b);

int nearest(int k, int n, int pieces) {
    return (2 * k * pieces + n) / (2 * n);
}

// The shares of a vertex of the grid: g sums up to n.
vec3 shares(ivec3 g, int n, ivec3 pieces) {
    int k;
    if (g.z == 0) {
        k = nearest(g.y, n, pieces.z);
        return vec3(pieces.z - k, k, 0) / float(pieces.z);
    }
    if (g.x == 0) {
        k = nearest(g.z, n, pieces.x);
        return vec3(0, pieces.x - k, k) / float(pieces.x);
    }
    if (g.y == 0) {
        k = nearest(g.x, n, pieces.y);
        return vec3(k, 0, pieces.y - k) / float(pieces.y);
    }
    return vec3(g) / float(n);
}

void main() {
    Edges triangle = edgesOf(gl_in[0].gl_Position, gl_in[1].gl_Position, gl_in[2].gl_Position);
    ivec3 pieces = ivec3(triangle.pieces);
    int n = max(max(pieces.x, pieces.y), pieces.z);
    for (int row = 0; row < n; ++row) {
        for (int k = n - row; k >= 0; --k) { // downwards, so that the strip keeps the triangle's winding
            vec3 lower = shares(ivec3(n - row - k, k, row), n, pieces);
            vertexAt(evenWeights(lower, triangle.angles, triangle.distances));
            if (k == 0)
                break;
            vec3 upper = shares(ivec3(n - row - k, k - 1, row + 1), n, pieces);
            vertexAt(evenWeights(upper, triangle.angles, triangle.distances));
        }
        EndPrimitive();
    }
}
