// Bailey, Clothier, Gebbie 2006: radius = C1 phi + C2 phi^2 + ... + C5 phi^5.
uniform float domeLens[5];

float lensRadius(float phi) {
    return phi * (domeLens[0] + phi * (domeLens[1] + phi * (domeLens[2] + phi * (domeLens[3] + phi * domeLens[4]))));
}
