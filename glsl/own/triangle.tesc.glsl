// A part of a program's own triangle, by the bits of the patch's number: which half of its widest edge each time.
layout(vertices = 3) out;
patch out vec3 domeShares[3]; // where the part's corners lie in the whole

vec4 cornerOf(vec3 share) {
    precise vec4 corner =
        share.x * gl_in[0].gl_Position + share.y * gl_in[1].gl_Position + share.z * gl_in[2].gl_Position;
    return corner;
}

void subdivide() {
    vec3 a = vec3(1.0, 0.0, 0.0), b = vec3(0.0, 1.0, 0.0), c = vec3(0.0, 0.0, 1.0);
    int halvings = int(domeHalvings);
    int way = gl_PrimitiveID & ((1 << halvings) - 1);
    for (int i = 0; i < halvings; ++i) {
        vec4 p = placeOf(cornerOf(a)), q = placeOf(cornerOf(b)), r = placeOf(cornerOf(c));
        float pq = widthOf(p, q), qr = widthOf(q, r), rp = widthOf(r, p);
        float widest = max(pq, max(qr, rp));
        if (!(widest > 1.0))
            break;
        vec3 first = a;
        if (qr == widest) {
            a = b, b = c, c = first;
            p = q, q = r;
        } else if (rp == widest) {
            a = c, c = b, b = first;
            q = p, p = r;
        }
        vec2 shares = middleOf(p, q);
        precise vec3 middle = shares.x * a + shares.y * b;
        if ((way & 1) == 0)
            b = middle;
        else
            a = middle;
        way >>= 1;
    }
    domeShares[0] = a;
    domeShares[1] = b;
    domeShares[2] = c;
    Edges triangle = edgesOf(cornerOf(a), cornerOf(b), cornerOf(c));
    if (way != 0)
        triangle.pieces = vec3(0.0); // another of its copies is this part
    setLevels(triangle);
}
