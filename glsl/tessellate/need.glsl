// How many pieces an edge needs, not yet whole: what is between its chords is off by at most R k a^2 / 6 pixels.
// domeDetail = sqrt(R k / (6 tolerance)).
uniform float domeDetail;

float needOf(vec3 a, vec3 b, float angle) {
    return angle * domeDetail;
}
