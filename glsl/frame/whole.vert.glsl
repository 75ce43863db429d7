// A triangle over all of the viewport.
void main() {
    gl_Position = vec4(number() == 1 ? 3.0 : -1.0, number() == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
