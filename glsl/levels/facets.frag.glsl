// The colour alone, a little darker on what is seen at a slant, so that shapes can be told. Along a line both
// steps lead the same way: it has no slant.
varying vec3 domeSeen;

void main() {
    vec3 right = dFdx(domeSeen), up = dFdy(domeSeen), across = cross(right, up);
    float size = length(across);
    float facing = 1.0;
    if (size > 1e-3 * length(right) * length(up))
        facing = min(abs(dot(across / size, normalize(domeSeen))), 1.0);
    gl_FragColor = vec4(gl_Color.rgb * mix(0.75, 1.0, facing), gl_Color.a);
}
