// Where on the line a vertex lies: even in angle.
layout(isolines, equal_spacing) in;
patch in float domeAngle;

vec2 weights() {
    vec2 s = vec2(1.0 - gl_TessCoord.x, gl_TessCoord.x);
    vec2 r = vec2(rayOf(placeOf(gl_in[0].gl_Position)).w, rayOf(placeOf(gl_in[1].gl_Position)).w);
    vec2 even = domeAngle > 1e-3 ? sin(s * domeAngle) : s;
    vec2 b = even * (min(r.x, r.y) / r);
    return b / (b.x + b.y);
}
