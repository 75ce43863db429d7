// Circles stay circles: domeLens = (where the picture ends, the slope there, 1 / tan(fov / 4)).
uniform vec3 domeLens;

float lensRadius(float phi) {
    float known = min(phi, domeLens.x);
    return domeLens.z * tan(0.5 * known) + domeLens.y * (phi - known);
}
