// Black outside the disc, to the pixel: domeDisc = (centre x, centre y, radius) in pixels of the frame.
uniform vec3 domeDisc;

void main() {
    if (distance(gl_FragCoord.xy, domeDisc.xy) <= domeDisc.z)
        discard;
    gl_FragColor = vec4(0.0, 0.0, 0.0, 1.0);
}
