// Point size by distance (GL_POINT_DISTANCE_ATTENUATION).
float pointSize(vec4 eye) {
    float r = length(eye.xyz / eye.w);
    float loss = gl_Point.distanceConstantAttenuation
        + r * (gl_Point.distanceLinearAttenuation + r * gl_Point.distanceQuadraticAttenuation);
    return clamp(gl_Point.size * inversesqrt(loss), gl_Point.sizeMin, gl_Point.sizeMax);
}
