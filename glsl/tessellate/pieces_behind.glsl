// How many pieces an edge needs, more towards straight behind. An arc is nowhere nearer to it than its nearer end
// less half its own angle.
float piecesOf(vec3 a, vec3 b, float angle) {
    float behind = min(angleBetween(a, domeAft.xyz), angleBetween(b, domeAft.xyz)) - 0.5 * angle;
    float detail = detailBetween(a, b) / clamp(behind, domeAft.w, 1.0);
    return clamp(ceil(angle * detail - 0.001), 1.0, DOME_MOST_PIECES);
}
