// The picture on the dome's inside, with a seam around it; from outside only a shade of it.
uniform sampler2D picture;
in vec2 shown;
in vec3 room;
out vec4 colour;
const float SEAM = 0.006;

void main() {
    vec3 light = texture(picture, shown).rgb;
    if (length(shown - 0.5) > 0.5 - SEAM)
        light = vec3(0.22);
    if (gl_FrontFacing)
        light = mix(vec3(0.16, 0.17, 0.19), light, 0.4);
    colour = vec4(light, 1.0);
}
