// A ring from just inside the rim to beyond the frame, at the very front: only what it covers costs anything.
uniform vec3 domeDisc;
uniform vec2 domeFrame;
const int PIECES = 128;

void main() {
    float turn = 6.283185307 * float(gl_VertexID / 2) / float(PIECES);
    float radius = gl_VertexID % 2 == 0 ? max(domeDisc.z - 1.0, 0.0) : domeFrame.x + domeFrame.y;
    vec2 pixel = domeDisc.xy + radius * vec2(cos(turn), sin(turn));
    gl_Position = vec4(2.0 * pixel / domeFrame - 1.0, 0.0, 1.0);
}
