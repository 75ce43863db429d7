// A part of a program's own line, by the bits of the patch's number: which half each time.
layout(vertices = 2) out;
patch out vec2 domeShares[2]; // where the part's ends lie in the whole

vec4 cornerOf(vec2 share) {
    precise vec4 corner = share.x * gl_in[0].gl_Position + share.y * gl_in[1].gl_Position;
    return corner;
}

void subdivide() {
    vec2 a = vec2(1.0, 0.0), b = vec2(0.0, 1.0);
    int halvings = int(domeHalvings);
    int way = gl_PrimitiveID & ((1 << halvings) - 1);
    for (int i = 0; i < halvings; ++i) {
        vec4 p = placeOf(cornerOf(a)), q = placeOf(cornerOf(b));
        if (!(widthOf(p, q) > 1.0))
            break;
        vec2 shares = middleOf(p, q);
        precise vec2 middle = shares.x * a + shares.y * b;
        if ((way & 1) == 0)
            b = middle;
        else
            a = middle;
        way >>= 1;
    }
    domeShares[0] = a;
    domeShares[1] = b;
    Edges line = edgesOf(cornerOf(a), cornerOf(b));
    if (way != 0)
        line.pieces = 0.0; // another of its copies is this part
    setLevels(line);
}
