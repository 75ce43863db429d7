// The program keeps part of its view outside MODELVIEW: domeView = inverse(P) * PROJECTION.
uniform mat4 domeView;

vec4 placed(vec4 eye) {
    return domeView * eye;
}
