// Bailey, Clothier, Gebbie 2006: radius = C1 phi + C2 phi^2 + ... + C5 phi^5.
// domeLens = (where the picture ends, the slope there, C1, .., C5).
uniform float domeLens[7];

float lensRadius(float phi) {
    float x = min(phi, domeLens[0]);
    float beyond = domeLens[1] * (phi - x);
    return x * (domeLens[2] + x * (domeLens[3] + x * (domeLens[4] + x * (domeLens[5] + x * domeLens[6])))) + beyond;
}
