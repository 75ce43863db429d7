// The dome's axis is raised by an angle: domeTilt = (cos, sin).
uniform vec2 domeTilt;

vec4 tilted(vec4 p) {
    return vec4(p.x, domeTilt.x * p.y + domeTilt.y * p.z, domeTilt.x * p.z - domeTilt.y * p.y, p.w);
}
