// Radius grows evenly with the angle: domeLens = 1 / (fov / 2).
uniform float domeLens;

float lensRadius(float phi) {
    return domeLens * phi;
}
