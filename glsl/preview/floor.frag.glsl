// The floor: a ring each metre, and a line from the middle to the front.
in vec2 shown;
in vec3 room;
out vec4 colour;

void main() {
    float far = length(room.xz);
    float ring = abs(fract(far + 0.5) - 0.5);
    float line = smoothstep(0.0, fwidth(far) * 1.5, ring - 0.01);
    float front = room.z < 0.0 ? smoothstep(0.0, fwidth(room.x) * 1.5, abs(room.x) - 0.02) : 1.0;
    colour = vec4(mix(vec3(0.30, 0.32, 0.36), vec3(0.10, 0.105, 0.115), min(line, front)), 1.0);
}
