// A line by its angle; nothing of one that lies wholly where the dome does not reach.
layout(vertices = 2) out;
patch out float domeAngle;
patch out vec2 domeNearness; // of each end: least distance over its own

void subdivide() {
    vec4 p0 = placeOf(gl_in[0].gl_Position), p1 = placeOf(gl_in[1].gl_Position);
    vec4 d0 = rayOf(p0), d1 = rayOf(p1);
    float angle = angleBetween(d0.xyz, d1.xyz);
    domeNearness = min(d0.w, d1.w) / vec2(d0.w, d1.w);
    bool out_ = reach(p0) < 0.0 && reach(p1) < 0.0;
    domeAngle = angle;
    gl_TessLevelOuter[0] = out_ || isnan(angle) ? 0.0 : 1.0;
    gl_TessLevelOuter[1] = piecesOf(angle);
}
