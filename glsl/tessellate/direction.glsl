// Unit direction and length of a homogeneous point, safe from 1e-30 to 1e30.
vec4 rayOf(vec4 p) {
    p = p.w < 0.0 ? -p : p;
    float largest = max(max(abs(p.x), abs(p.y)), abs(p.z));
    vec3 d = largest > 0.0 ? p.xyz / largest : vec3(0.0, 0.0, -1.0);
    float size = length(d);
    return vec4(d / size, largest * size);
}
