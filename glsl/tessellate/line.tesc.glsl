// A line by its angle; nothing of one that lies wholly where the dome does not reach.
layout(vertices = 2) out;
patch out float domeAngle;

void subdivide() {
    vec4 p0 = placeOf(gl_in[0].gl_Position), p1 = placeOf(gl_in[1].gl_Position);
    float angle = angleBetween(rayOf(p0).xyz, rayOf(p1).xyz);
    bool out_ = reach(p0) < 0.0 && reach(p1) < 0.0;
    domeAngle = angle;
    gl_TessLevelOuter[0] = out_ || isnan(angle) ? 0.0 : 1.0;
    gl_TessLevelOuter[1] = piecesOf(angle);
}
