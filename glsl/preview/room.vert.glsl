// A corner of the room, and where of the picture it is.
uniform mat4 toClip;
in vec3 place;
in vec2 at;
out vec2 shown;
out vec3 room;

void main() {
    shown = at;
    room = place;
    gl_Position = toClip * vec4(place, 1.0);
}
