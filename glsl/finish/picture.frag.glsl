// The finished picture as the projector gets it: part = (left, bottom, width, height) of it in the texture;
// fade = (the radius where it begins to fade, where it ends) with 1 the inscribed circle; brightness and 1 / gamma.
uniform sampler2D picture;
uniform vec4 part;
uniform vec2 fade;
uniform vec2 tone;
in vec2 at;
in float light;
out vec4 color;

void main() {
    vec3 seen = texture(picture, part.xy + at * part.zw).rgb;
    float radius = length(2.0 * at - 1.0);
    float edge = fade.x < fade.y ? 1.0 - smoothstep(fade.x, fade.y, radius) : 1.0;
    color = vec4(pow(clamp(seen * (light * edge * tone.x), 0.0, 1.0), vec3(tone.y)), 1.0);
}
