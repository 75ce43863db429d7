// A parallelogram's angles, its corners' distances, and the pieces of its edges and of its inside both ways; none
// of one that lies wholly where the dome does not reach, or has no finite place, or a corner in the eye.
struct Edges {
    vec4 angles; // of the edge from each corner to the next
    vec4 distances;
    vec4 pieces;
    vec2 inside;
};

// A place inside is off along two edges' ways at once, and needs finer pieces than an edge.
const float DOME_INSIDE = 1.3;

// The pieces inside, along two edges and across the middle from a to b, which may be wider than both.
float insideOf(float edge0, float edge1, vec3 a, vec3 b) {
    float middle = needOf(normalize(a), normalize(b), angleBetween(a, b));
    return min(ceil(max(DOME_INSIDE * middle, max(edge0, edge1))), DOME_MOST_PIECES);
}

Edges edgesOf(vec4 corner0, vec4 corner1, vec4 corner2, vec4 corner3) {
    vec4 p0 = placeOf(corner0), p1 = placeOf(corner1), p2 = placeOf(corner2), p3 = placeOf(corner3);
    vec4 d0 = rayOf(p0), d1 = rayOf(p1), d2 = rayOf(p2), d3 = rayOf(p3);
    Edges quad;
    vec4 angles = vec4(angleBetween(d0.xyz, d1.xyz), angleBetween(d1.xyz, d2.xyz), angleBetween(d2.xyz, d3.xyz),
        angleBetween(d3.xyz, d0.xyz));
    quad.angles = angles;
    quad.distances = vec4(d0.w, d1.w, d2.w, d3.w);
    bool reached = max(max(reach(p0), reach(p1)), max(reach(p2), reach(p3))) >= 0.0;
    bool sound = min(min(d0.w, d1.w), min(d2.w, d3.w)) > 0.0 && !isnan(dot(angles, vec4(1.0)));
    quad.pieces = vec4(0.0);
    quad.inside = vec2(1.0);
    if (reached && sound) {
        quad.pieces = vec4(piecesOf(d0.xyz, d1.xyz, angles.x), piecesOf(d1.xyz, d2.xyz, angles.y),
            piecesOf(d2.xyz, d3.xyz, angles.z), piecesOf(d3.xyz, d0.xyz, angles.w));
        quad.inside = vec2(insideOf(quad.pieces.x, quad.pieces.z, d0.xyz + d3.xyz, d1.xyz + d2.xyz),
            insideOf(quad.pieces.y, quad.pieces.w, d0.xyz + d1.xyz, d3.xyz + d2.xyz));
    }
    return quad;
}
