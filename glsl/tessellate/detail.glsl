// How many pieces an arc of one radian between two directions needs: a chord of angle a is off by at most
// R k a^2 / 8 pixels. domeDetails = sqrt(R k / (8 tolerance)) for all k of the lens, then for those of ever smaller
// caps around its axis; domeAft = (the direction straight behind, the least angle from it that counts).
uniform float domeDetails[8];
uniform vec4 domeAft;

float detailBetween(vec3 a, vec3 b) {
    precise float ahead = -max(dot(a, domeAft.xyz), dot(b, domeAft.xyz));
    return domeDetails[int(clamp(8.0 * ahead, 0.0, 7.0))];
}
