// The dome as seen from far below: domeLens = (where the picture ends, the slope there, 1 / sin(fov / 2)).
uniform vec3 domeLens;

float lensRadius(float phi) {
    float known = min(phi, domeLens.x);
    return domeLens.z * sin(known) + domeLens.y * (phi - known);
}
