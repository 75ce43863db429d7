// How many pieces an edge needs. What the CPU leaves whole shall not come out as two by rounding.
float piecesOf(vec3 a, vec3 b, float angle) {
    return clamp(ceil(angle * detailBetween(a, b) - 0.001), 1.0, DOME_MOST_PIECES);
}
