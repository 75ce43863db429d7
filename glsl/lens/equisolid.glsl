// Equal solid angles have equal areas: domeLens = (where the picture ends, the slope there, 1 / sin(fov / 4)).
uniform vec3 domeLens;

float lensRadius(float phi) {
    float known = min(phi, domeLens.x);
    return domeLens.z * sin(0.5 * known) + domeLens.y * (phi - known);
}
