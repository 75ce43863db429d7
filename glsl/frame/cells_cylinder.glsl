// A grid over a cylindrical screen: share of its height and of its width -> the place there, and the ray that lands
// there: bend/cylinder backwards.
vec3 rayAt(vec2 share, out vec2 place) {
    place = share.yx * 2.0 - 1.0;
    float azimuth = place.x / domeLens.x;
    return vec3(sin(azimuth), place.y / domeLens.y + domeLens.z, -cos(azimuth));
}
