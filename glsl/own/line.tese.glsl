// Where on the program's whole line a vertex of the tessellator's lies.
patch in vec2 domeShares[2];

vec2 share() {
    vec2 b = weights();
    precise vec2 whole = b.x * domeShares[0] + b.y * domeShares[1];
    return whole;
}
