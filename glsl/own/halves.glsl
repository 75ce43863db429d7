// An edge wider than domeWidest, radians, or of too many pieces is halved first, as often as there are bits in the patch's number for it:
// each primitive comes 2^domeHalvings times, and each of those finds its own part. Nothing but an edge's two ends
// decides whether and where it is halved, so neighbours do it alike.
uniform float domeHalvings;
uniform float domeWidest;

// Over 1: to be halved.
float widthOf(vec4 p, vec4 q) {
    vec3 a = rayOf(p).xyz, b = rayOf(q).xyz;
    float angle = angleBetween(a, b);
    return max(angle / domeWidest, DOME_FINER * needOf(a, b, angle) / DOME_MOST_PIECES);
}

// The shares of the two ends in the place halfway, even in angle.
vec2 middleOf(vec4 p, vec4 q) {
    vec4 a = rayOf(p), b = rayOf(q);
    return evenOnEdge(vec2(0.5), angleBetween(a.xyz, b.xyz), vec2(a.w, b.w));
}
