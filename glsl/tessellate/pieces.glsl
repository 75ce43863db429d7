// How many pieces an edge needs: what is between its chords is off by at most R k a^2 / 6 pixels.
// domeDetail = sqrt(R k / (6 tolerance)). What the CPU leaves whole shall not come out as two by rounding.
uniform float domeDetail;

float piecesOf(vec3 a, vec3 b, float angle) {
    return clamp(ceil(angle * domeDetail - 0.001), 1.0, DOME_MOST_PIECES);
}
