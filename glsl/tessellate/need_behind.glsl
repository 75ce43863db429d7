// How many pieces an edge needs, not yet whole, more towards straight behind: domeAft = (that direction, the
// least angle from it that counts). An arc is nowhere nearer to it than its nearer end less half its own angle.
// Around what is left out they are twice as many, for where that ends the inside of triangles is seen,
// which is less even.
uniform float domeDetail;
uniform vec4 domeAft;

float needOf(vec3 a, vec3 b, float angle) {
    float behind = min(angleBetween(a, domeAft.xyz), angleBetween(b, domeAft.xyz)) - 0.5 * angle;
    return angle * domeDetail / min(max(behind, domeAft.w) - domeAft.w / 2.0, 1.0);
}
