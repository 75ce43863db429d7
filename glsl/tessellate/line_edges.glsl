// A line's angle, its ends' distances and its pieces; none of one that lies wholly where the dome does not
// reach, or has no finite place, or an end in the eye.
struct Edges {
    float angle;
    vec2 distances;
    float pieces;
};

Edges edgesOf(vec4 end0, vec4 end1) {
    vec4 p0 = placeOf(end0), p1 = placeOf(end1);
    vec4 d0 = rayOf(p0), d1 = rayOf(p1);
    Edges line;
    line.angle = angleBetween(d0.xyz, d1.xyz);
    line.distances = vec2(d0.w, d1.w);
    bool reached = reach(p0) >= 0.0 || reach(p1) >= 0.0;
    line.pieces = reached && min(d0.w, d1.w) > 0.0 && !isnan(line.angle) ? piecesOf(d0.xyz, d1.xyz, line.angle) : 0.0;
    return line;
}
