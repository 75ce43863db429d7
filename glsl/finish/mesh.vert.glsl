// A node of the mesh that the finished picture is drawn by: where it goes, what it shows, and how bright.
in vec2 place;
in vec2 shown;
in float intensity;
out vec2 at;
out float light;

void main() {
    at = shown;
    light = intensity;
    gl_Position = vec4(place, 0.0, 1.0);
}
