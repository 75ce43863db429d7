// A curve through knots, cubic between two: domeLens = (angle, radius, slope, 0), the angles rising from 0.
uniform vec4 domeLens[64];

float lensRadius(float phi) {
    int i = 0;
    int stride = 32;
    for (int halving = 0; halving < 6; halving++) {
        if (domeLens[i + stride].x <= phi)
            i += stride;
        stride /= 2;
    }
    vec4 a = domeLens[i];
    if (i == 63)
        return a.y + a.z * (phi - a.x); // beyond the last knot: straight on
    vec4 b = domeLens[i + 1];
    float width = b.x - a.x;
    float t = (phi - a.x) / width;
    float u = 1.0 - t;
    return u * u * ((1.0 + 2.0 * t) * a.y + t * width * a.z) + t * t * ((1.0 + 2.0 * u) * b.y - u * width * b.z);
}
