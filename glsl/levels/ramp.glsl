// The colour of so many pieces an edge: domeRamp has that of an edge left whole, then of 1, 2, 4, 8 and 16 pieces.
uniform vec4 domeRamp[6];

vec4 ofPieces(float n) {
    if (n < 1.0)
        return domeRamp[0];
    float place = min(log2(n), 4.0);
    int below = int(min(place, 3.0));
    return mix(domeRamp[below + 1], domeRamp[below + 2], place - float(below));
}
