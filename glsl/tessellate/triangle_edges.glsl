// A triangle's angles, its corners' distances and its edges' pieces; none of one that lies wholly where the
// dome does not reach, or has no finite place, or a corner in the eye.
struct Edges {
    vec3 angles; // of the edge opposite to each corner
    vec3 distances;
    vec3 pieces;
};

Edges edgesOf(vec4 corner0, vec4 corner1, vec4 corner2) {
    vec4 p0 = placeOf(corner0), p1 = placeOf(corner1), p2 = placeOf(corner2);
    vec4 d0 = rayOf(p0), d1 = rayOf(p1), d2 = rayOf(p2);
    Edges triangle;
    vec3 angles = vec3(angleBetween(d1.xyz, d2.xyz), angleBetween(d2.xyz, d0.xyz), angleBetween(d0.xyz, d1.xyz));
    triangle.angles = angles;
    triangle.distances = vec3(d0.w, d1.w, d2.w);
    bool reached = reach(p0) >= 0.0 || reach(p1) >= 0.0 || reach(p2) >= 0.0;
    bool sound = min(min(d0.w, d1.w), d2.w) > 0.0 && !isnan(angles.x + angles.y + angles.z);
    triangle.pieces = vec3(0.0);
    if (reached && sound)
        triangle.pieces = vec3(
            piecesOf(d1.xyz, d2.xyz, angles.x), piecesOf(d2.xyz, d0.xyz, angles.y), piecesOf(d0.xyz, d1.xyz, angles.z));
    return triangle;
}
