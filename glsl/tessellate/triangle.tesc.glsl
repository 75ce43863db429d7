// A triangle's edges by their angles; nothing of a triangle that lies wholly where the dome does not reach.
layout(vertices = 3) out;
patch out vec3 domeAngles; // of the edge opposite to each vertex
patch out vec3 domeNearness; // of each vertex: least distance over its own

void subdivide() {
    vec4 p0 = placeOf(gl_in[0].gl_Position), p1 = placeOf(gl_in[1].gl_Position), p2 = placeOf(gl_in[2].gl_Position);
    vec4 d0 = rayOf(p0), d1 = rayOf(p1), d2 = rayOf(p2);
    vec3 angles = vec3(angleBetween(d1.xyz, d2.xyz), angleBetween(d2.xyz, d0.xyz), angleBetween(d0.xyz, d1.xyz));
    domeNearness = min(min(d0.w, d1.w), d2.w) / vec3(d0.w, d1.w, d2.w);
    bool out_ = reach(p0) < 0.0 && reach(p1) < 0.0 && reach(p2) < 0.0;
    bool broken = isnan(angles.x + angles.y + angles.z);
    domeAngles = angles;
    vec3 pieces = out_ || broken ? vec3(0.0) : vec3(piecesOf(angles.x), piecesOf(angles.y), piecesOf(angles.z));
    gl_TessLevelOuter[0] = pieces.x;
    gl_TessLevelOuter[1] = pieces.y;
    gl_TessLevelOuter[2] = pieces.z;
    gl_TessLevelInner[0] = max(max(pieces.x, pieces.y), pieces.z);
}
