// The dome's axis is not the program's forward direction: domeTurn takes eye space to the dome's.
uniform mat3 domeTurn;

vec4 aimed(vec4 p) {
    return vec4(domeTurn * p.xyz, p.w);
}
