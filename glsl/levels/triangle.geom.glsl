// The most pieces of an edge of the triangle.
float pieces() {
    vec3 n = edgesOf(gl_in[0].gl_Position, gl_in[1].gl_Position, gl_in[2].gl_Position).pieces;
    return max(max(n.x, n.y), n.z);
}
