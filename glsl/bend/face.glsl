// A point in one cube face's own axes: right and up by the tangent at the face's edge, and ahead.
uniform mat4 domeFace;

vec3 onFace(vec4 p) {
    return mat3(domeFace) * p.xyz;
}
