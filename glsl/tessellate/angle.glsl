// The angle between two directions; both neighbours of an edge find the same, bit by bit.
float angleBetween(vec3 a, vec3 b) {
    precise vec3 across = vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
    precise float along = a.x * b.x + a.y * b.y + a.z * b.z;
    return atan(length(across), along);
}
