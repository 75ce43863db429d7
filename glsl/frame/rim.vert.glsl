// Two rings around the disc, by number() alone: a narrow one over its edge, which is cut to the pixel, and one
// from there to beyond the frame.
uniform vec3 domeDisc;
uniform vec2 domeFrame;
const int PIECES = 32;

void main() {
    int pair = number() / 2, rings = pair / (PIECES + 1);
    int ring = rings + number() - 2 * pair;
    float turn = 6.283185307 * float(pair - rings * (PIECES + 1)) / float(PIECES);
    float around = (domeDisc.z + 1.0) / cos(3.141592654 / float(PIECES)); // no piece cuts the disc
    float radius = ring == 0 ? max(domeDisc.z - 1.0, 0.0) : ring == 1 ? around : around + domeFrame.x + domeFrame.y;
    vec2 pixel = domeDisc.xy + radius * vec2(cos(turn), sin(turn));
    gl_Position = vec4(2.0 * pixel / domeFrame - 1.0, 0.0, 1.0);
}
