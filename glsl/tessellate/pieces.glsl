// An edge's pieces. One that has to be cut is cut finer than the tolerance asks: else a wall's picture within it
// is worse than a cube map's, for the nearer an edge's pieces are to those inside, the less triangles lean
// between the two. What the CPU leaves whole shall not come out as two by rounding.
const float DOME_FINER = 1.3;

float piecesOf(vec3 a, vec3 b, float angle) {
    float need = needOf(a, b, angle);
    return need <= 1.001 ? 1.0 : min(ceil(DOME_FINER * need), DOME_MOST_PIECES);
}
