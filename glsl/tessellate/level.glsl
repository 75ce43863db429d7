// How many pieces an edge needs: a chord of angle a is off by at most R k a^2 / 8 pixels.
// domeDetail = sqrt(R k / (8 tolerance)). Both neighbours of an edge find the same, bit by bit.
uniform float domeDetail;

float angleBetween(vec3 a, vec3 b) {
    precise vec3 across = vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
    precise float along = a.x * b.x + a.y * b.y + a.z * b.z;
    return atan(length(across), along);
}

float piecesOf(float angle) {
    return clamp(ceil(angle * domeDetail), 1.0, DOME_MOST_PIECES);
}
