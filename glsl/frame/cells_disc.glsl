// A grid over the disc: share of its radius and of a turn -> the place there, and the ray that lands there.
// domeHalf: half the field of view in radians.
uniform float domeHalf;

vec3 rayAt(vec2 share, out vec2 place) {
    float phi = domeHalf * share.x, theta = 6.28318530718 * share.y;
    vec2 away = vec2(cos(theta), sin(theta));
    place = lensRadius(phi) * away;
    return vec3(sin(phi) * away, -cos(phi));
}
