// The weights of a quad's corners at a place between its first corner (0, 0), (1, 0), (1, 1) and (0, 1): GL
// draws it as two triangles, which share the way from the second corner to the fourth.
vec4 onHalves(vec2 place) {
    float beyond = place.x + place.y - 1.0;
    return beyond <= 0.0 ? vec4(-beyond, place.x, 0.0, place.y) : vec4(0.0, 1.0 - place.y, beyond, 1.0 - place.x);
}
