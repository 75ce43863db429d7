// Where on the line a vertex lies: even in angle.
layout(isolines, equal_spacing) in;
patch in float domeAngle;
patch in vec2 domeNearness;

vec2 weights() {
    vec2 s = vec2(1.0 - gl_TessCoord.x, gl_TessCoord.x);
    vec2 even = domeAngle > 1e-3 ? sin(s * domeAngle) : s;
    vec2 b = even * domeNearness;
    return b / (b.x + b.y);
}
