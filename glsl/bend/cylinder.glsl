// Where a direction lands on a cylindrical screen around the viewer: across by its azimuth, up by the tangent of its
// elevation. domeLens = (1 / half the screen's angle, 1 / half its height, the height of its middle), in radii.
uniform vec3 domeLens;

vec2 landed(vec3 d) {
    float height = d.y / max(length(d.xz), 1e-6);
    return vec2(domeLens.x * atan(d.x, -d.z), domeLens.y * (height - domeLens.z));
}
