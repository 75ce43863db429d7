// OpenCV's fisheye: radius = f phi (1 + k1 phi^2 + k2 phi^4 + k3 phi^6 + k4 phi^8).
// domeLens = (where the picture ends, the slope there, f, k1, .., k4).
uniform float domeLens[7];

float lensRadius(float phi) {
    float x = min(phi, domeLens[0]);
    float xx = x * x;
    float stretch = 1.0 + xx * (domeLens[3] + xx * (domeLens[4] + xx * (domeLens[5] + xx * domeLens[6])));
    return domeLens[2] * x * stretch + domeLens[1] * (phi - x);
}
