// Black outside the disc where its square goes to four corners: domeToSquare takes a place of the frame's square back.
uniform vec3 domeDisc;
uniform mat3 domeToSquare;
uniform float domeHalfSide;

void main() {
    vec3 place = domeToSquare * vec3((gl_FragCoord.xy - domeDisc.xy) / domeHalfSide, 1.0);
    if (place.z > 0.0 && length(place.xy) * domeHalfSide <= domeDisc.z * place.z)
        discard;
    gl_FragColor = vec4(0.0, 0.0, 0.0, 1.0);
}
