// Where in the program's whole triangle a vertex of the tessellator's lies.
patch in vec3 domeShares[3];

vec3 share() {
    vec3 b = weights();
    precise vec3 whole = b.x * domeShares[0] + b.y * domeShares[1] + b.z * domeShares[2];
    return whole;
}
